import { batchOf, createAnswers, packRays, verdictsOfRoots } from '../../math/batch.ts';
import { sign } from '../../math/exact.ts';
import { METHODS } from '../../math/index.ts';
import { seeded } from '../../math/rng.ts';
import { MINUS } from '../../text/format.ts';
import { lossesOf } from '../losses.ts';
import { plainText } from '../plain-text.ts';
import { operationsOf } from '../steps.ts';
import type { MapFrame } from './frame.ts';
import { markByte, VERDICTS } from './marks.ts';
import { type MapRequest, raysOf } from './request.ts';
import { failingPixels } from './summary.ts';
import { PIXELS, SIDE } from './window.ts';

/** Pixels that are looked at closely. */
const LOOKED_AT = 24;
/** Pixels whose verdict exact arithmetic confirms. */
const CONFIRMED = 256;
const SEED = 2026;

/** Which pixels of a whole map are looked at. */
export interface ProbeRequest {
  readonly request: MapRequest;
  /** Some of the failing pixels; of the right ones that lost most digits where none fails. */
  readonly looked: readonly number[];
  readonly isFailing: boolean;
  /** Pixels, with the verdicts that certified gave, as bytes. */
  readonly confirmed: readonly (readonly [pixel: number, truth: number])[];
}

/** A line of the derivation, and in how many of the pixels it is the one. */
export interface Torn {
  /** As it is written: D, A, N·d; '' where no line has a name. */
  readonly line: string;
  /** 'unknown': its sign is not known; 'wrong': it is another one than the exact sign. */
  readonly how: 'wrong' | 'unknown' | 'digits';
  readonly pixels: number;
}

export interface Probe {
  readonly torn: readonly Torn[];
  readonly looked: number;
  readonly isFailing: boolean;
  /** Of how many pixels exact arithmetic has the verdict that certified gave. */
  readonly agreed: number;
  readonly asked: number;
}

/** Chosen from a seed, so that the same map is looked at in the same places. */
export function probeFor(request: MapRequest, frame: MapFrame): ProbeRequest {
  const random = seeded(SEED);
  const oneOf = (all: readonly number[]): number => all[Math.floor(random() * all.length)] ?? 0;
  const failing = failingPixels(frame);
  const from = failing.length > 0 ? failing : mostLost(frame);
  const looked = from.length === 0 ? [] : Array.from({ length: LOOKED_AT }, () => oneOf(from));
  const withRay = Array.from({ length: PIXELS }, (_, pixel) => pixel).filter(
    (pixel) => frame.marks[pixel] !== markByte('nothing'),
  );
  // The truth of a ray that leaves a surface is not the class of the one that comes.
  const count = request.start || withRay.length === 0 ? 0 : CONFIRMED;
  const confirmed = Array.from({ length: count }, () => {
    const pixel = oneOf(withRay);
    return [pixel, frame.truth[pixel] as number] as const;
  });
  return { request, looked, isFailing: failing.length > 0, confirmed };
}

function mostLost({ lost }: MapFrame): number[] {
  const most = lost.reduce((a, b) => Math.max(a, b), 0);
  if (most === 0) return [];
  return [...lost.keys()].filter((pixel) => 2 * (lost[pixel] as number) > most);
}

/** Reads the traces of some pixels, and asks exact arithmetic about others. */
export function probe({ request, looked, isFailing, confirmed }: ProbeRequest): Probe {
  const rays = raysOf(request);
  const lines = new Map<string, Torn>();
  let seen = 0;
  for (const pixel of request.start ? [] : looked) {
    const at = rays.at(pixel % SIDE, Math.floor(pixel / SIDE));
    const method = METHODS.find(({ id }) => id === request.method);
    if (!at || !method?.parts) continue;
    seen += 1;
    const found = isFailing
      ? tornIn(operationsOf(method, at.shape, at.ray))
      : { line: lineOf(lossesOf(method, at.shape, at.ray).worst), how: 'digits' as const };
    const key = `${found.how} ${found.line}`;
    lines.set(key, { ...found, pixels: (lines.get(key)?.pixels ?? 0) + 1 });
  }
  return {
    torn: [...lines.values()].sort((a, b) => b.pixels - a.pixels),
    looked: seen,
    isFailing,
    agreed: agreedOn(request, confirmed),
    asked: confirmed.length,
  };
}

type Operations = ReturnType<typeof operationsOf>;

/** A of a curved shape decides first, N·d of a flat one: where that is 0, others do. */
const FIRST: ReadonlySet<string> = new Set(['A', 'N·d']);

/**
 * The line that decides wrongly: the first one, or where that has its exact sign the one that
 * decides next. Of a figure what remains is the comparison with its rim.
 */
function tornIn(operations: Operations): Pick<Torn, 'line' | 'how'> {
  const named = new Map(
    operations.flatMap((one) =>
      one.letter && one.inputs.length > 0 ? [[lineOf(one), one] as const] : [],
    ),
  );
  const first = [...named.keys()].find((line) => FIRST.has(line)) ?? '';
  const isStraight = named.get(first)?.sign === 0;
  const next = first === 'A' ? (isStraight ? ['B', 'C'] : ['D']) : isStraight ? [OFFSET] : [];
  for (const line of [first, ...next]) {
    const operation = named.get(line);
    if (!operation) continue;
    const { sign: own, exact } = operation;
    if (Number.isNaN(own)) return { line, how: 'unknown' };
    if (exact !== null && own !== sign(exact)) return { line, how: 'wrong' };
  }
  return { line: RIM, how: 'wrong' };
}

const OFFSET = `N·(E ${MINUS} P)`;
/** The comparison of the point with the figure's rim, which has no letter. */
export const RIM = 'rim';

const lineOf = (operation: Pick<Operations[number], 'letter' | 'expr'> | null): string =>
  operation ? plainText(operation.letter ?? operation.expr) : '';

function agreedOn(request: MapRequest, confirmed: ProbeRequest['confirmed']): number {
  const rays = raysOf(request);
  const exact = METHODS.find(({ id }) => id === 'exact');
  const out = createAnswers(1);
  return confirmed.filter(([pixel, truth]) => {
    const at = rays.at(pixel % SIDE, Math.floor(pixel / SIDE));
    if (!at || !exact) return false;
    batchOf(exact, at.shape).both(packRays([at.ray]), out);
    return verdictsOfRoots(out, 1)[0] === VERDICTS[truth];
  }).length;
}
