import type { Intersection } from '../math/index.ts';
import type { CurvedDetails, Naming } from '../math/shapes.ts';
import { sidesOf } from './sides.ts';
import { type Comparison, cannotDecide, zero } from './verdict-parts.ts';
import {
  CONSTANT,
  NONE,
  ONE,
  SINGULAR,
  type Side,
  type Sides,
  sideKey,
  TOUCHES,
  TWO,
} from './verdict-table.ts';

interface CurvedVerdict {
  readonly relations: readonly Comparison[];
  readonly text: string;
}

const LETTERS = { A: 'A', B: 'B', C: 'C', D: 'D' };

export function curvedVerdict(
  found: Intersection,
  details: CurvedDetails,
  naming: Naming,
): CurvedVerdict {
  const { signs } = details;
  const compared = (relation: '<' | '>'): Comparison[] => [{ left: 'D', relation, right: '0' }];
  const opens = signs.A === -1 ? '-' : '+';
  const sides = sidesOf(found).map(sideKey).join('');
  switch (found.class) {
    case 'two':
      return { relations: compared('>'), text: TWO[opens][sides as Sides] ?? 'two points' };
    case 'tangent':
      return { relations: [zero('D')], text: tangent(found, naming, opens)[sides as Side] };
    case 'one': {
      const text = ONE[signs.B === -1 ? '-' : '+'][sides as Side];
      return { relations: [zero('A')], text: `${parallel(naming)}: ${text}` };
    }
    case 'contained':
      return { relations: [zero('A'), zero('B'), zero('C')], text: contained(naming) };
    case 'none': {
      if (signs.A !== 0) return { relations: compared('<'), text: NONE[opens] };
      const text = CONSTANT[signs.C === -1 ? '-' : '+'];
      return { relations: [zero('A'), zero('B')], text: `${parallel(naming)}, ${text}` };
    }
    case 'undecided':
      return { relations: [], text: cannotDecide(details, signs, LETTERS) };
  }
}

function tangent({ hits }: Intersection, { singular }: Naming, opens: '-' | '+') {
  if (!hits[0]?.singular) return TOUCHES[opens];
  // A method may round a normal to zero although the exact one is not zero.
  return SINGULAR[opens](singular ?? 'a point whose normal is rounded to zero');
}

const parallel = ({ straight }: Naming): string => `parallel to ${straight ?? 'the surface'}`;

function contained({ name }: Naming): string {
  return name === 'axis'
    ? 'the line is the axis itself: every t is a root'
    : 'the whole line lies in the surface: every t is a root';
}
