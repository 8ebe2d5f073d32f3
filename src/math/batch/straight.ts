import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { float32 } from '../arithmetic/float32.ts';
import { float64 } from '../arithmetic/float64.ts';
import type { Values } from '../formula/evaluate.ts';
import { lazily } from '../lazily.ts';
import type { Method } from '../methods/define.ts';
import type { Shape } from '../shapes/index.ts';
import { definitionOf } from '../shapes/lookup.ts';
import { type Axis, axisIndex, type Vec3 } from '../vec3.ts';
import {
  type Answers,
  chooseFirst,
  type Kernel,
  keepUnsettled,
  NONE,
  ONE,
  type Rays,
  TANGENT,
  TWO,
  UNDECIDED,
  VERDICTS,
} from './batch.ts';
import { NUMBERS, STRAIGHT } from './generated/index.ts';
import { largestIn, mayLackNormal } from './normals.ts';
import { AT_ROOTS, SLOT } from './one-ray.ts';
import { ASK, type Ask, CLASS_BIT, type Loops, PLACE } from './straight-loop.ts';

const ownSlot = lazily(() => new Float64Array(SLOT));

/** Where a method's loops for a kind of shape come from; null where there are none. */
export type Source = (method: string, kind: string) => Loops | null;

/** The roots' part of `selectFirst`, of rays 0 … count − 1. */
export type Choose = (out: Answers, count: number, tMin: number, tMax: number) => void;

const chosen: Choose = (out, count, tMin, tMax) => chooseFirst(out, 0, count, tMin, tMax);

export const inTypeScript: Source = (method, kind) => STRAIGHT[method]?.loops()[kind] ?? null;

/** The loops of `source`, and the method itself for what they cannot settle; null without loops. */
export function straightKernel(
  method: Method,
  shape: Shape,
  source: Source,
  choose: Choose = chosen,
): Kernel | null {
  const loops = source(method.id, shape.kind);
  if (!loops || !isOrdinary(method, shape)) return null;
  const met = definitionOf(shape).formula(shape).family === 'curved' ? 'two' : 'one';
  const usual = met === 'two' ? TWO : ONE;
  const turn = turnOf(shape);
  const numbers = numbersOf(shape, turn);
  let marked = new Int32Array(0);
  const alone = met === 'two' ? (STRAIGHT[method.id]?.alone ?? null) : null;
  const form = alone?.forms[shape.kind];
  const format = FORMATS[STRAIGHT[method.id]?.arithmetic ?? ''] as Arithmetic<number>;
  const values = definitionOf(shape).values(shape);

  /** Ray i by the method itself: its class as a place in VERDICTS, its roots in `out`. */
  function askAlone({ Ex, Ey, Ez, dx, dy, dz }: Rays, i: number, out: Answers): number {
    const E: Vec3 = [Ex[i] as number, Ey[i] as number, Ez[i] as number];
    const d: Vec3 = [dx[i] as number, dy[i] as number, dz[i] as number];
    // In float32 even what the formula does not look at may be out of range.
    if (!alone || !form || !(isInRange(E, format) && isInRange(d, format))) {
      const found = method.intersect(shape, { origin: E, direction: d });
      out.t0[i] = found.hits[0]?.t ?? Number.NaN;
      out.t1[i] = found.hits[1]?.t ?? Number.NaN;
      return VERDICTS.indexOf(found.class);
    }
    const slot = ownSlot();
    form(values, E, d, slot);
    const place = alone.roots(slot);
    const [near, far] = [slot[AT_ROOTS] as number, slot[AT_ROOTS + 1] as number];
    const lost = isLost(near, place === TWO || place === ONE || place === TANGENT);
    const isTold = !lost && !isLost(far, place === TWO);
    out.t0[i] = isTold ? near : Number.NaN;
    out.t1[i] = isTold ? far : Number.NaN;
    return isTold ? place : UNDECIDED;
  }

  function ask(form: Ask, rays: Rays, out: Answers): void {
    out.rareCount = 0;
    if (marked.length < rays.count) marked = new Int32Array(rays.count);
    const { rareIndex, rareVerdict } = out;
    const left = (loops as Loops)[form](numbers, turned(rays, turn), out, marked, form === 'both');
    let listed = 0;
    for (let k = 0; k < left; k++) {
      const i = (marked[k] as number) & PLACE;
      let place = (marked[k] as number) >>> CLASS_BIT;
      if (place === ASK) {
        place = askAlone(rays, i, out);
        out.margin[i] = place === NONE ? -1 : 1;
        if (place === NONE || place === usual) continue;
      }
      rareIndex[listed] = i;
      rareVerdict[listed++] = place;
    }
    out.rareCount = listed;
  }

  return {
    met,
    both: (rays, out) => ask('both', rays, out),
    classes: (rays, out) => ask('classes', rays, out),
    first(rays, tMin, tMax, out) {
      ask('both', rays, out);
      choose(out, rays.count, tMin, tMax);
      keepUnsettled(out);
    },
  };
}

const isInRange = ([x, y, z]: Vec3, { of }: Arithmetic<number>): boolean =>
  of(x) - of(x) + (of(y) - of(y)) + (of(z) - of(z)) === 0;

/** A root that overflowed is no answer. Points and normals are never NaN: isOrdinary. */
const isLost = (t: number, isRoot: boolean): boolean => isRoot && !(t - t === 0);

/** Shapes whose numbers are outside of this are the trees' in intervals, and flat ones in pairs. */
const LEAST = 2 ** -100;
const MOST = 2 ** 100;
const isInBox = (x: number): boolean => x === 0 || (Math.abs(x) > LEAST && Math.abs(x) < MOST);

const FORMATS: Readonly<Record<string, Arithmetic<number>>> = { float32, float64 };

/** A place that a loop in double-double answers for is within PLACES, and its normal in range. */
const PLACES = 2 ** 501;
const GREATEST = 2 ** 990;

/** Whether the loops' conditions are enough for this shape. */
function isOrdinary(method: Method, shape: Shape): boolean {
  const arithmetic = STRAIGHT[method.id]?.arithmetic ?? '';
  const format = FORMATS[arithmetic];
  const { formula, values } = definitionOf(shape);
  const own = formula(shape);
  if (format) return own.family === 'flat' || !mayLackNormal(own, values(shape), format);
  return own.family === 'curved' && arithmetic === 'double-double'
    ? largestIn(own, values(shape), PLACES) < GREATEST
    : numbersOf(shape, 0).every(isInBox);
}

/** A shape that lies along an axis is looked at from there: x is the axis, then y and z follow. */
function turnOf(shape: Shape): number {
  const param = definitionOf(shape).params.find(({ type }) => type === 'axis');
  return param ? axisIndex((shape as unknown as Record<string, Axis>)[param.key] as Axis) : 0;
}

function turned(rays: Rays, turn: number): Rays {
  if (turn === 0) return rays;
  const { count, Ex, Ey, Ez, dx, dy, dz } = rays;
  return turn === 1
    ? { count, Ex: Ey, Ey: Ez, Ez: Ex, dx: dy, dy: dz, dz: dx }
    : { count, Ex: Ez, Ey: Ex, Ez: Ey, dx: dz, dy: dx, dz: dy };
}

function numbersOf(shape: Shape, turn: number): Float64Array {
  const { scalars, vectors } = definitionOf(shape).values(shape) as Values<number>;
  const names = NUMBERS[shape.kind] ?? [];
  return Float64Array.from(names, (name) => {
    const [id, part] = name.split('.') as [string, string?];
    if (part === undefined) return scalars[id] as number;
    return vectors[id]?.[((Number(part) + turn) % 3) as 0 | 1 | 2] as number;
  });
}
