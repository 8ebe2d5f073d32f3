import type {
  CurvedDetails,
  FlatDetails,
  Intersection,
  PlaneHit,
  Sign,
} from '../math/intersection.ts';
import type { Places, ShapeDefinition } from '../math/shapes/define.ts';
import type { Shape } from '../math/shapes/index.ts';
import { display } from '../text/format.ts';
import { subscript } from '../text/scripts.ts';
import type { HitRole } from './scene-model.ts';

/** A relation in symbols, and what it means: "D > 0", "two points: the ray enters, then leaves". */
export interface VerdictWords {
  readonly relations: readonly Comparison[];
  readonly text: string;
}

export interface Comparison {
  /** A quantity's name as the derivation calls it. */
  readonly left: string;
  readonly relation: '=' | '<' | '>' | '≠' | '≤';
  readonly right: string;
}

/** What a root is to someone who follows the ray from E. */
export interface HitWords {
  readonly index: number;
  readonly t: number;
  readonly role: HitRole;
  /** "first hit, enters", "behind E", "0.13 outside" */
  readonly text: string;
}

const zero = (left: string): Comparison => ({ left, relation: '=', right: '0' });

/** What the sentences need to know of a shape. */
export type Named = Pick<ShapeDefinition<Shape>, 'title' | 'places'>;

/** The case in words, true of the line and of the ray from E. */
export function verdictWords(found: Intersection, shape: Named): VerdictWords {
  const { details } = found;
  return details.family === 'curved'
    ? curvedVerdict(found, details, shape)
    : flatVerdict(found, details, shape);
}

function curvedVerdict(
  found: Intersection,
  { signs }: CurvedDetails,
  { places }: Named,
): VerdictWords {
  const sign = (left: string, relation: '<' | '>'): Comparison[] => [
    { left, relation, right: '0' },
  ];
  switch (found.class) {
    case 'two':
      return { relations: sign('D', '>'), text: twoPoints(found, signs.A) };
    case 'tangent':
      return { relations: [zero('D')], text: tangent(found, places) };
    case 'one':
      return { relations: [zero('A')], text: `parallel to a generator: one point${behind(found)}` };
    case 'contained':
      return {
        relations: [zero('A'), zero('B'), zero('C')],
        text: 'the whole line lies in the surface: every t is a root',
      };
    case 'none':
      return signs.A === 0
        ? { relations: [zero('A'), zero('B')], text: noSlope(signs.C, places) }
        : { relations: sign('D', '<'), text: 'no point: the ray misses' };
    case 'undecided':
      return { relations: [], text: 'cannot decide: a number overflowed' };
  }
}

function twoPoints({ hits }: Intersection, A: Sign | null): string {
  const behindE = hits.filter(({ t }) => t < 0).length;
  const inwards = A !== -1;
  if (behindE === 2) return 'two points, both behind E: the ray itself misses';
  if (behindE === 1) {
    if (inwards && hits[1]?.t === 0) {
      return 'two points: one behind E, one at E itself, where the ray leaves';
    }
    return inwards
      ? 'two points: E is inside, the ray leaves'
      : 'two points: one behind E, one where the ray enters';
  }
  return inwards
    ? 'two points: the ray enters, then leaves'
    : 'two points: the ray leaves, then enters again';
}

function tangent({ hits }: Intersection, places: Places | null): string {
  const [hit] = hits;
  const where = hit && hit.t < 0 ? ', behind E' : '';
  if (!hit?.singular) return `tangent: one double root, the ray touches${where}`;
  const place = places?.singular ?? 'a singular point';
  return `through ${place}: one double root, no normal there${where}`;
}

function behind({ hits }: Intersection): string {
  return hits[0] && hits[0].t < 0 ? ', behind E' : '';
}

function noSlope(C: Sign | null, places: Places | null): string {
  const where = `parallel to ${places?.straight ?? 'the surface'}`;
  const side = C === -1 ? ', inside for ever' : ', outside for ever';
  return `${where}${side}: no root`;
}

function flatVerdict(found: Intersection, details: FlatDetails, { title }: Named): VerdictWords {
  const { plane, signs, meetsFigure } = details;
  if (plane) return planeVerdict(found, details, title);
  if (signs.rate === null || found.class === 'undecided') {
    return { relations: [], text: 'cannot decide: a number overflowed' };
  }
  if (found.class === 'none') {
    return { relations: [zero('N.d')], text: 'parallel to the plane, beside it: no point' };
  }
  const crosses =
    meetsFigure === null ? '' : ` and ${meetsFigure ? 'crosses' : 'passes beside'} the ${title}`;
  return {
    relations: [zero('N.d'), zero('N.(E-P)')],
    text: `the line lies in the plane${crosses}: no single point`,
  };
}

function planeVerdict(found: Intersection, { plane }: FlatDetails, title: string): VerdictWords {
  const relations: Comparison[] = [{ left: 'N.d', relation: '≠', right: '0' }];
  const where = plane && plane.t < 0 ? ', behind E' : '';
  if (found.class === 'undecided') return { relations, text: 'cannot decide: a number overflowed' };
  if (found.class === 'one') {
    return plane?.holds.length === 0
      ? { relations, text: `one point${where}` }
      : { relations, text: `one point, inside the ${title}${where}` };
  }
  const far = plane && knownDistance(plane);
  const by = far === null ? '' : `${far} `;
  return { relations, text: `the plane is met ${by}outside the ${title}${where}: no point` };
}

/** A float rung may know that a point is outside and not how far: the squares overflow first. */
function knownDistance({ distance }: PlaneHit): string | null {
  return Number.isNaN(distance) ? null : display(distance, 3);
}

/** Every root with its role; a point of the plane outside the figure is listed too, as rejected. */
export function hitWords(found: Intersection): HitWords[] {
  const { details } = found;
  if (details.family === 'flat' && details.plane && details.plane.inside === false) {
    const far = knownDistance(details.plane);
    const text = far === null ? 'outside' : `outside by ${far}`;
    return [{ index: 1, t: details.plane.t, role: 'outside', text }];
  }
  const first = found.hits.findIndex(({ t }) => t >= 0);
  return found.hits.map(({ t }, i) => {
    const role: HitRole = t < 0 ? 'behind' : i === first ? 'first' : 'other';
    return { index: i + 1, t, role, text: hitText(found, i, role) };
  });
}

function hitText(found: Intersection, i: number, role: HitRole): string {
  const how = crossing(found, i);
  if (role === 'behind') return 'behind E';
  const start = found.hits[i]?.t === 0 ? 'E itself' : role === 'first' ? 'first hit' : '';
  return [start, how].filter(Boolean).join(', ');
}

/** Whether f changes from outside (+) to inside (−) there, from the sign of f′; nothing for a flat shape. */
function crossing({ class: verdict, hits, details }: Intersection, i: number): string {
  if (details.family === 'flat') return hits[i]?.t === 0 ? 'in the plane' : '';
  if (verdict === 'tangent') return hits[i]?.singular ? 'double, no normal' : 'double, touches';
  const { A, B } = details.signs;
  const rising = verdict === 'one' ? B === 1 : (A === 1) === (i === 1);
  return rising ? 'leaves' : 'enters';
}

/** "t₁ = 2.26918, first hit, enters" */
export function hitSentence({ index, t, text }: HitWords): string {
  return `t${subscript(index)} = ${display(t)}, ${text}`;
}
