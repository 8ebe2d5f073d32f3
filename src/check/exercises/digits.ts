import { findFamily, madeFamilies } from '../../math/families.ts';
import type { Shape, Vec3 } from '../../math/index.ts';
import { integer, pick, type Random, randomSign } from '../../math/rng.ts';
import { type CurvedDetails, findMethod, findShape, type ShapeKind } from '../../math/shapes.ts';
import { display } from '../../text/format.ts';
import { type Answers, choiceField, type Input } from '../types.ts';
import { type Draft, type Exercise, spreadOver } from './define.ts';
import { drawUntil, kindsOf, numberOf } from './draw.ts';

const LINES = [
  { id: 'A', title: 'A: its terms cancel' },
  { id: 'B', title: 'B: its terms cancel' },
  { id: 'C', title: 'C: its terms cancel, E is near the surface' },
  { id: 'D', title: 'D: B² and 4AC cancel' },
  { id: 't', title: 't: −B and √D cancel' },
  { id: 'nowhere', title: 'nowhere: all lines keep their digits' },
];

/** Methods that may restore the digits, from the cheapest to the most expensive. */
const CURES = [
  { id: 'textbook', title: 'nothing: the textbook formula will do' },
  { id: 'stable', title: 'another formula for the smaller root (stable)' },
  { id: 'moment', title: 'D from the moment d × (E − C) (moment)' },
  { id: 'compensated', title: 'twice the digits on the way (compensated)' },
];

/**
 * Nearly along a generator of slope 1, in numbers that make A, B and C exact: (1 + 2^-26)² needs
 * just 53 bits. 4AC is tiny against B², and only −B ± √D is left to lose the digits.
 */
const SLIGHTLY_MORE = 1 + 2 ** -26;

function alongGenerator(random: Random): Input {
  const quarters = (size: number): Vec3 => [
    integer(random, -4 * size, 4 * size) / 4,
    integer(random, -4 * size, 4 * size) / 4,
    integer(random, -4 * size, 4 * size) / 4,
  ];
  const at = quarters(2);
  const shape: Shape =
    random() < 0.5
      ? { kind: 'cone', vertex: at, slope: 1 }
      : { kind: 'hyperboloid', center: at, flare: 1, radius: integer(random, 1, 8) / 4 };
  const direction: Vec3 = [randomSign(random) * SLIGHTLY_MORE, randomSign(random), 0];
  return { shape, ray: { origin: quarters(6), direction } };
}

type Draw = (random: Random) => Input;

/** Rays of a family; the ids are those of src/math/families. */
function drawOf(id: string): Draw {
  const family = findFamily(id);
  if (!family) throw new RangeError(`no family ${id}`);
  return (random) => family.make(random);
}

/** Rays of the round shapes that have families of their own. */
const DRAWS: readonly [Draw, ...Draw[]] = [
  drawOf('typical'),
  drawOf('far-origin'),
  drawOf('cancellation'),
  drawOf('near-tangent'),
  drawOf('near-axis'),
  alongGenerator,
];

/** Rays about a shape of this kind, for any curved one. */
export const allDraws = (kind: ShapeKind): readonly [Draw, ...Draw[]] =>
  findShape(kind)?.ownFamilies
    ? DRAWS
    : (GROUPS.flatMap((group) =>
        madeFamilies(kind, group).map(
          ({ make }): Draw =>
            (random) =>
              make(random),
        ),
      ) as unknown as readonly [Draw, ...Draw[]]);

const GROUPS = ['ordinary', 'special', 'hard'] as const;

/** "A 16, B 12": names with their right digits. */
const listed = (each: readonly (readonly [string, number])[]): string =>
  each.map(([name, kept]) => `${name} ${Math.floor(kept)}`).join(', ');

/** Fewer than `LOST` right digits count as lost, `KEPT` or more as kept; between is not asked. */
const LOST = 9;
const KEPT = 13;

export const digits: Exercise = {
  id: 'digits',
  topic: 'where the digits go',
  paper: false,
  // The draws above are about shapes with families of their own.
  kinds: kindsOf('curved').filter((kind) => findShape(kind)?.ownFamilies),
  spread: spreadOver('line', ['A', 'C', 'D', 't', 'nowhere'], { cylinder: ['A', 't'] }),
  draw(random, kind) {
    return drawnFrom(pick(random, DRAWS), random, kind);
  },
  ask: () =>
    'In doubles, on which line does the textbook method first lose digits here (fewer than nine ' +
    'left)? And what is the cheapest cure?',
  given: ['A', 'B', 'C', 'D'],
  fields: () => [
    choiceField('line', 'first lost on', LINES),
    choiceField('cure', 'cured by', CURES),
  ],
  answers: (course, draft) =>
    course.rules.loss === 'measured' ? (measured(draft) ?? {}) : { line: 't', cure: 'stable' },
  argue: (draft, found) => {
    const [B, D] = [numberOf(found, 'B'), numberOf(found, 'D')];
    const product = 4 * numberOf(found, 'A') * numberOf(found, 'C');
    const { lines, cures } = keptDigits(draft) ?? { lines: [], cures: [] };
    return {
      rule:
        'A line loses the digits in which its terms agree, and later lines cannot get them ' +
        'back.',
      put:
        `B² = ${display(B * B)} and 4AC = ${display(product)}; −B = ${display(-B)} and √D = ` +
        `${display(Math.sqrt(D))}: which of them nearly cancel? Or do the terms of A, B or C ` +
        `already?`,
      decision: [
        `Right digits, line by line: ${listed(lines)}.`,
        `Right digits of the roots: ${listed(cures.map(({ id, kept }) => [id, kept]))}.`,
      ],
    };
  },
  clue: 'Two nearly equal numbers that are subtracted leave only the digits in which they differ.',
  lines: ['A', 'B', 'C', 'D', 't'],
};

/** As `digits`, also about the shapes whose families are made from their parameters. */
export const allDigits: Exercise = {
  ...digits,
  id: 'digits.2',
  kinds: kindsOf('curved'),
  spread: spreadOver('line', ['A', 'C', 'D', 't', 'nowhere'], {
    cylinder: ['A', 't'],
    sphere: ['A', 'C', 't'],
    paraboloid: ['A', 'C', 't'],
  }),
  draw(random, kind, _, wanted) {
    const draws = allDraws(kind);
    return drawnFrom((numbers) => pick(numbers, draws)(numbers), random, kind, wanted);
  },
};

/** A ray about this kind on which a line, or the wanted one, clearly loses digits or none does. */
function drawnFrom(make: Draw, random: Random, kind: ShapeKind, wanted?: string): Draft | null {
  const made = drawUntil(
    () => make(random),
    (drawn) => {
      const line = sameKind(drawn, kind) ? measured(drawn)?.line : undefined;
      return line !== undefined && (wanted === undefined || line === wanted);
    },
  );
  return made && { ...made, watch: measured(made)?.line === 't' ? [] : ['loss-always-t'] };
}

export const sameKind = ({ shape }: Input, kind: string): boolean => Object.is(shape.kind, kind);

/** Right decimal digits of x, 0 to 16. */
export function digitsRight(x: number, truth: number): number {
  if (x === truth) return 16;
  const error = Math.abs(x - truth) / Math.abs(truth);
  return Number.isFinite(error) ? Math.min(16, Math.max(0, -Math.log10(error))) : 0;
}

/** Right digits of the textbook's lines, and of each method's roots; null without two roots. */
export function keptDigits({ shape, ray }: Input): Kept | null {
  const of = (id: string) => findMethod(id)?.intersect(shape, ray);
  const exact = of('exact');
  const textbook = of('textbook');
  if (exact?.class !== 'two' || !textbook) return null;
  const truth = exact.details as CurvedDetails;
  const own = textbook.details as CurvedDetails;
  const rootDigits = (id: string): number => {
    const found = of(id);
    if (found?.hits.length !== 2) return 0;
    return Math.min(
      ...found.hits.map(({ t }, i) => digitsRight(t, exact.hits[i]?.t ?? Number.NaN)),
    );
  };
  const lines: [string, number][] = (['A', 'B', 'C', 'D'] as const).map((id) => [
    id,
    digitsRight(own[id], truth[id]),
  ]);
  lines.push(['t', rootDigits('textbook')]);
  return { lines, cures: CURES.map(({ id }) => ({ id, kept: rootDigits(id) })) };
}

interface Kept {
  readonly lines: readonly (readonly [string, number])[];
  readonly cures: readonly { readonly id: string; readonly kept: number }[];
}

/** The answers; null if a line is between lost and kept. */
export function measured(input: Input): Answers | null {
  const found = keptDigits(input);
  if (!found) return null;
  const { lines, cures } = found;
  const at = lines.findIndex(([, kept]) => kept < KEPT);
  const line = lines[at];
  if (line && line[1] > LOST) return null;
  const best = cures.findIndex(({ kept }) => kept >= KEPT);
  const cure = cures[best];
  if (!cure || cures.slice(0, best).some(({ kept }) => kept > LOST)) return null;
  // Not asked if a line loses digits that the roots do not need.
  if ((line === undefined) !== (cure.id === 'textbook')) return null;
  return { line: line?.[0] ?? 'nowhere', cure: cure.id };
}
