import {
  type Answers,
  batchOf,
  createAnswers,
  createRays,
  type Kernel,
  kernelArray,
  type Rays,
  verdictsOfRoots,
} from '../../math/batch.ts';
import { sign } from '../../math/exact.ts';
import type { Question } from '../../math/families.ts';
import { type Expr, evaluate, exact, valuesOf } from '../../math/formula.ts';
import { InvalidInput, METHODS, type Ray, type Shape } from '../../math/index.ts';
import { definitionOf, findMethod, type Method, quote } from '../../math/shapes.ts';
import { rayAt } from '../plan.ts';
import type { MapAxis } from './axes.ts';
import { createLeaving } from './leaving.ts';
import { lostDigits, markByte, markOf, VERDICTS } from './marks.ts';
import { type MapRequest, raysOf } from './request.ts';
import { SIDE } from './window.ts';

/** Some pixels of a map, in the order of `pixels`. */
export interface MapPart {
  /** row · SIDE + column; rows from the bottom. */
  readonly pixels: Int32Array;
  readonly marks: Uint8Array;
  /** Digits of 16 that the worse root has lost, in tenths; 0 where there is none to compare. */
  readonly lost: Uint8Array;
  readonly said: Uint8Array;
  readonly truth: Uint8Array;
  /** The exact sign of A, or of N·d, plus 1. */
  readonly leading: Uint8Array;
}

interface Mapper {
  /** Ray and shape at a pixel, as the kernel gets them; null where there are none. */
  at(column: number, row: number): Question | null;
  part(pixels: Int32Array): MapPart;
}

/** Kernels that one mapper keeps: a column each of two maps. */
const MOST_KERNELS = 2 * SIDE;

/**
 * @throws InvalidInput for an axis that the shape has not, twice the same, or an unknown method.
 */
export function createMapper(request: MapRequest): Mapper {
  const { start } = request;
  const { axes, at } = raysOf(request);
  const [x, y] = axes;
  const method = methodOf(request.method);
  const certified = methodOf('certified');
  const leading = leadingOf(x, y);
  const kernels = new Map<number, readonly [Kernel, Kernel]>();

  /** Which pixels have one shape, as a number. */
  const groupOf = (pixel: number): number =>
    (x.of === 'shape' ? (pixel % SIDE) + 1 : 0) +
    (y.of === 'shape' ? (SIDE + 1) * (Math.floor(pixel / SIDE) + 1) : 0);

  function kernelsFor(group: number, own: Shape): readonly [Kernel, Kernel] {
    const known = kernels.get(group);
    if (known) return known;
    // A kernel for a single ray takes longer to make than the ray to be answered.
    const make = x.of === 'shape' && y.of === 'shape' ? oneByOne : batchOf;
    const made = [make(method, own), make(certified, own)] as const;
    if (make === batchOf && kernels.size < MOST_KERNELS) kernels.set(group, made);
    return made;
  }

  return {
    at,
    part(pixels) {
      const found = createPart(pixels);
      const groups = new Map<number, Member[]>();
      pixels.forEach((pixel, place) => {
        const column = pixel % SIDE;
        const row = (pixel - column) / SIDE;
        const question = at(column, row);
        if (!question) return;
        found.leading[place] = leading(column, row, question) + 1;
        const group = groupOf(pixel);
        const members = groups.get(group);
        if (members) members.push({ place, question });
        else groups.set(group, [{ place, question }]);
      });
      const room = roomFor(Math.max(0, ...[...groups.values()].map(({ length }) => length)));
      const leave = start && createLeaving(start);
      for (const [group, members] of groups) {
        const [first] = members;
        if (!first) continue;
        const own = first.question.shape;
        const [asked, sure] = kernelsFor(group, own);
        fill(room.rays, members);
        if (leave) {
          leave(own, asked, sure, room.rays, (i, mark) => {
            found.marks[members[i]?.place ?? 0] = markByte(mark);
          });
        } else {
          asked.both(room.rays, room.own);
          sure.both(room.rays, room.true);
          compare(members, room, found);
        }
      }
      return found;
    },
  };
}

/** The kernel of a method's `intersect`, which has the same bits. */
function oneByOne(method: Method, shape: Shape): Kernel {
  const both = (rays: Rays, out: Answers): void => {
    out.rareCount = 0;
    for (let i = 0; i < rays.count; i++) {
      const { class: verdict, hits } = method.intersect(shape, rayAt({ rays }, i));
      out.t0[i] = hits[0]?.t ?? Number.NaN;
      out.t1[i] = hits[1]?.t ?? Number.NaN;
      out.rareIndex[i] = i;
      out.rareVerdict[i] = VERDICTS.indexOf(verdict);
      out.rareCount += 1;
    }
  };
  return {
    met: 'two',
    both,
    classes: both,
    first(rays, tMin, tMax, out) {
      both(rays, out);
      for (let i = 0; i < rays.count; i++) {
        const roots = [out.t0[i] as number, out.t1[i] as number];
        out.t0[i] = roots.find((t) => t >= tMin && t <= tMax) ?? Number.NaN;
        out.t1[i] = Number.NaN;
      }
    },
  };
}

/** A pixel of a part, with its ray. */
interface Member {
  readonly place: number;
  readonly question: Question;
}

interface MapBuffers {
  readonly rays: Rays;
  readonly own: Answers;
  readonly true: Answers;
}

const roomFor = (count: number): MapBuffers => ({
  rays: createRays(count, kernelArray),
  own: createAnswers(count, kernelArray),
  true: createAnswers(count, kernelArray),
});

function fill(rays: Rays, members: readonly Member[]): void {
  rays.count = members.length;
  members.forEach(({ question: { ray } }, i) => {
    [rays.Ex[i], rays.Ey[i], rays.Ez[i]] = ray.origin;
    [rays.dx[i], rays.dy[i], rays.dz[i]] = ray.direction;
  });
}

function createPart(pixels: Int32Array): MapPart {
  const bytes = (): Uint8Array => new Uint8Array(pixels.length);
  return {
    pixels,
    marks: bytes().fill(markByte('nothing')),
    lost: bytes(),
    said: bytes(),
    truth: bytes(),
    leading: bytes().fill(1),
  };
}

function compare(
  members: readonly Member[],
  { rays, own, true: sure }: MapBuffers,
  to: MapPart,
): void {
  const said = verdictsOfRoots(own, rays.count);
  const truth = verdictsOfRoots(sure, rays.count);
  members.forEach(({ place }, i) => {
    const [mine, right] = [said[i] ?? 'undecided', truth[i] ?? 'none'];
    const mark = markOf(mine, right);
    to.marks[place] = markByte(mark);
    to.said[place] = VERDICTS.indexOf(mine);
    to.truth[place] = VERDICTS.indexOf(right);
    if (mark === 'right') {
      to.lost[place] = lostDigits(
        [own.t0[i] as number, own.t1[i] as number],
        [sure.t0[i] as number, sure.t1[i] as number],
      );
    }
  });
}

function methodOf(id: string): Method {
  const found = METHODS.find((method) => method.id === id);
  if (!found) throw new InvalidInput(`${quote(id)} is not a method`);
  return found;
}

/** The exact sign of A, or of N·d, which d and the shape alone decide. */
function leadingOf(x: MapAxis, y: MapAxis): (column: number, row: number, at: Question) => number {
  const known = new Map<number, number>();
  const [byColumn, byRow] = [x.of !== 'origin', y.of !== 'origin'];
  const isKept = !byColumn || !byRow;
  return (column, row, { shape: own, ray }) => {
    const key = (byColumn ? column + 1 : 0) + (byRow ? row + 1 : 0);
    const before = isKept ? known.get(key) : undefined;
    if (before !== undefined) return before;
    const found = signAt(leadingTree(own), own, ray);
    if (isKept) known.set(key, found);
    return found;
  };
  // The shape's kind stays, so its tree does.
  function leadingTree(own: Shape): Expr {
    const formula = definitionOf(own).formula(own);
    return formula.family === 'curved' ? formula.A : formula.rate;
  }
}

/** The exact sign: by intervals where these tell it, else in whole numbers. */
export function signAt(tree: Expr, shape: Shape, ray: Ray): number {
  const quick = findMethod('interval')?.parts?.(({ arithmetic: ar }) =>
    ar.sign(evaluate(tree, ar, valuesOf(shape, ray, ar))),
  );
  if (quick !== undefined && !Number.isNaN(quick)) return quick;
  return sign(evaluate(tree, exact, valuesOf(shape, ray, exact)));
}
