import { numbersOf } from '../../scripts/kernels/trees/program.ts';
import { measure, type Plan, type Task } from '../../src/lab/run.ts';
import type { Quartiles } from '../../src/lab/stats.ts';
import { quartiles } from '../../src/lab/stats.ts';
import { batchOf } from '../../src/math/batch/kernels.ts';
import { bytesOf, createSimdMemory, type SimdMemory } from '../../src/math/batch/simd-memory.ts';
import { inTypeScript, straightKernel } from '../../src/math/batch/straight.ts';
import { PLACE } from '../../src/math/batch/straight-loop.ts';
import { simdSource } from '../../src/math/batch/straight-simd.ts';
import {
  type Answers,
  createAnswers,
  createRays,
  type Kernel,
  quadricOf,
  type Rays,
} from '../../src/math/batch.ts';
import type { Family } from '../../src/math/families.ts';
import type { Shape } from '../../src/math/index.ts';
import { CERTIFIED_SIMD } from '../../src/math/methods/certified/generated/certified-simd.ts';
import { type FastStages, useFastStages } from '../../src/math/methods/certified/kernel.ts';
import { certifiedQuadric } from '../../src/math/methods/certified/numbers.ts';
import { createFastStages } from '../../src/math/methods/certified/simd.ts';
import {
  BLOCK,
  coarseAroundAxis,
  coarseInSpace,
  createScratch,
  residualsAroundAxis,
  residualsInSpace,
  solvePass,
} from '../../src/math/methods/certified/units.ts';
import { seeded } from '../../src/math/rng.ts';
import { definitionOf } from '../../src/math/shapes/lookup.ts';
import type { Method } from '../../src/math/shapes.ts';
import { type Compiled, compiled } from './compiled.ts';
import { spread, table } from './ladder-report.ts';
import { countsOf, KINDS, operationLines, operationsOfFirst, questionOf } from './operations.ts';
import { clock, ratioOf, type Sample, TARGETS, type Target } from './prices.ts';
import { put } from './rays.ts';
import {
  oneRoot,
  orderedByProducts,
  PIECES,
  type Piece,
  RANGE,
  reading,
  STEP,
  steps,
  unordered,
} from './trials.ts';

/*
 * Why prices are what they are: what loops are made of is counted, and timed piece by piece beside
 * them; and what might be cheaper is made by the same generator, and timed as well. All of it on
 * the same rays in the same run, in random order.
 */

const MANY = 16_384;

/** A whole number of vectors of each format, at most MANY; where they are fewer, of one shape. */
export const sampleOf = (rays = MANY): Sample => ({
  seed: 2026,
  shapes: rays < MANY ? 1 : 6,
  count: 4 * Math.ceil(Math.min(rays, MANY) / 4),
});

export const REASONS = ['<!-- reasons -->', '<!-- /reasons -->'] as const;

/** Milliseconds a round, all shapes together, by id. */
type Sums = Map<string, number[]>;

const PIECE_IDS = Object.keys(STEP) as Piece[];
const idOf = (what: string, target: Target): string => `${what}, ${target}`;

interface Room {
  readonly memory: SimdMemory;
  readonly stages: FastStages;
  readonly kernelOf: (method: Method, shape: Shape, target: Target) => Kernel;
  readonly rays: Rays;
  readonly out: Answers;
  readonly marked: Int32Array;
}

/** Kernels and trials in one memory, so that all of them find the same arrays where they are. */
function roomFor(count: number): Room {
  const memory = createSimdMemory();
  const stages = createFastStages(memory, bytesOf(CERTIFIED_SIMD));
  const source = simdSource(memory);
  const make = (length: number): Float64Array => {
    const array = memory.allocate(length);
    if (!array) throw new RangeError(`no room for ${length} numbers`);
    return array;
  };
  return {
    memory,
    stages,
    rays: createRays(count, make),
    out: createAnswers(count, make),
    marked: new Int32Array(count),
    kernelOf: (method, shape, target) =>
      (target === 'simd' ? straightKernel(method, shape, source, stages.first) : null) ??
      (target === 'typescript' ? straightKernel(method, shape, inTypeScript) : null) ??
      batchOf(method, shape, target),
  };
}

/** What the shape's symbols stand for, in the order of a loop's numbers. */
function valuesOf(shape: Shape, names: readonly string[]): number[] {
  const { scalars, vectors } = definitionOf(shape).values(shape);
  return names.map((name) => {
    const [id, part] = name.split('.') as [string, string?];
    return part === undefined
      ? (scalars[id] as number)
      : (vectors[id]?.[Number(part) as 0 | 1 | 2] as number);
  });
}

/** The three passes of certified's first stage, one after the other, each over all blocks. */
function passTasks(shape: Shape, { rays, out }: Room): Task[] {
  const q = quadricOf(shape);
  const lattice = q && certifiedQuadric(q).lattice;
  if (!q || !lattice) return [];
  const scratch = createScratch();
  const coarse = (q.hasY ? coarseInSpace : coarseAroundAxis)(scratch);
  const residuals = (q.hasY ? residualsInSpace : residualsAroundAxis)(scratch);
  const solve = solvePass(scratch);
  const passes = [
    (from: number, to: number) => coarse(lattice, rays, out, from, to),
    () => residuals(lattice),
    () => solve(lattice, out),
  ];
  // Each number of passes beside the next one: the difference is the last one's.
  return passes.map((_, last) => ({
    id: passId(last),
    run() {
      for (let from = 0; from < rays.count; from += BLOCK) {
        for (const pass of passes.slice(0, last + 1)) {
          pass(from, Math.min(from + BLOCK, rays.count));
        }
      }
    },
  }));
}

const passId = (last: number): string => `certified, passes up to ${last + 1}`;

interface Trial {
  readonly id: string;
  readonly loops: Compiled;
  readonly numbers: Float64Array;
}

/** The trials on a shape. */
function trialsOf(shape: Shape, methods: readonly Method[], memory: SimdMemory): Trial[] {
  const asked = methods.flatMap((method) => {
    const question = questionOf(method, shape.kind);
    return question ? [{ id: method.id, question }] : [];
  });
  return asked.flatMap(({ id, question }) => {
    const names = numbersOf(question.symbols);
    const own = valuesOf(shape, names);
    const made = (
      what: string,
      program: ReturnType<typeof oneRoot>,
      more: number[] = [],
    ): Trial => ({
      id: what,
      loops: compiled({ program, numbers: [...names, ...RANGE] }, memory),
      numbers: Float64Array.of(...own, ...more),
    });
    return [
      made(`${id}, one root`, oneRoot(question), [0, Number.POSITIVE_INFINITY]),
      ...(id === 'textbook32' ? [made('float32, reading', reading(question))] : []),
      ...(id === 'textbook'
        ? [
            made('float64, reading', reading(question)),
            ...PIECE_IDS.map((piece) => made(piece, steps(question, piece))),
          ]
        : []),
      ...(id === 'stable'
        ? [
            made('stable, unordered', unordered(question)),
            made('stable, by products', orderedByProducts(question)),
          ]
        : []),
    ];
  });
}

/** Throws Error where a trial of one root has found another one than its method's `first`. */
function checkOneRoot(trial: Trial, target: Target, kernel: Kernel, room: Room): void {
  const { rays, out, marked } = room;
  kernel.first(rays, 0, Number.POSITIVE_INFINITY, out);
  const want = out.t0.slice();
  const left = trial.loops[target](trial.numbers, rays, out, marked, true);
  const open = new Set(Array.from(marked.subarray(0, left), (mark) => mark & PLACE));
  for (let i = 0; i < rays.count; i++) {
    if (open.has(i) || Object.is(out.t0[i], want[i])) continue;
    throw new Error(`${trial.id}, ${target}: ${out.t0[i]} for ray ${i}, not ${want[i]}`);
  }
}

export interface Reasons {
  readonly times: ReadonlyMap<string, readonly number[]>;
  /** Of both roots, by pieces: nanoseconds a ray, in the order of TARGETS. */
  readonly byPieces: ReadonlyMap<string, readonly number[]>;
  readonly rays: number;
  readonly sample: Sample;
  readonly plan: Plan;
}

export function reasonsOf(
  family: Family,
  sample: Sample,
  methods: readonly Method[],
  plan: Plan,
): Reasons {
  const room = roomFor(sample.count);
  const before = useFastStages(room.stages);
  try {
    return reasonsIn(room, family, sample, methods, plan);
  } finally {
    useFastStages(before);
  }
}

function reasonsIn(
  room: Room,
  family: Family,
  sample: Sample,
  methods: readonly Method[],
  plan: Plan,
): Reasons {
  const random = seeded(sample.seed);
  const { rays, out, marked, kernelOf } = room;
  const times: Sums = new Map();
  const counts = new Map<string, number[]>();
  for (let n = 0; n < sample.shapes; n++) {
    const { shape, rays: list } = family.batch(random, sample.count);
    put(rays, list);
    const tasks: Task[] = passTasks(shape, room);
    const trials = trialsOf(shape, methods, room.memory);
    for (const target of TARGETS) {
      for (const method of methods) {
        const kernel = kernelOf(method, shape, target);
        const trial = trials.find(({ id }) => id === `${method.id}, one root`);
        if (trial) checkOneRoot(trial, target, kernel, room);
        tasks.push(
          { id: idOf(`${method.id}, both`, target), run: () => kernel.both(rays, out) },
          {
            id: idOf(`${method.id}, first`, target),
            run: () => kernel.first(rays, 0, Number.POSITIVE_INFINITY, out),
          },
        );
      }
      for (const { id, loops, numbers } of trials) {
        const loop = loops[target];
        tasks.push({ id: idOf(id, target), run: () => loop(numbers, rays, out, marked, true) });
      }
    }
    for (const [id, rounds] of measure(tasks, clock, plan)) {
      const before = times.get(id);
      times.set(
        id,
        rounds.map((x, i) => x + (before?.[i] ?? 0)),
      );
    }
    for (const method of methods) {
      const more = countsOf(method, shape.kind);
      if (!more) continue;
      const sum = counts.get(method.id);
      counts.set(
        method.id,
        more.operations.map((x, k) => x + (sum?.[k] ?? 0)),
      );
    }
  }
  const total = sample.shapes * sample.count;
  const each = (id: string): number => (1e6 * quartiles(times.get(id) ?? []).median) / total;
  const byPieces = new Map(
    [...counts].map(([id, sums]) => [
      id,
      TARGETS.map((target) =>
        KINDS.reduce((sum, [name], k) => {
          const piece = PIECE_IDS.find((one) => one === name);
          const one = piece ? each(idOf(piece, target)) / PIECES : 0;
          return sum + (one * (sums[k] as number)) / sample.shapes;
        }, 0),
      ),
    ]),
  );
  return { times, byPieces, rays: total, sample, plan };
}

const nanoseconds = (x: number): string => (x >= 99.5 ? x.toFixed(0) : x.toPrecision(2));

/** What docs/bench.md quotes. */
export function reasonLines(reasons: Reasons, methods: readonly Method[]): string[] {
  const { times, byPieces, rays, sample, plan } = reasons;
  const ratio = (id: string, base: string): Quartiles | null => ratioOf(times, id, base);
  const each = (id: string): number => (1e6 * quartiles(times.get(id) ?? []).median) / rays;
  const inBoth = (of: (target: Target) => string): string =>
    `${of('simd')} in SIMD, ${of('typescript')} in TypeScript`;
  const toTextbook = (what: string): string =>
    inBoth((t) => spread(ratio(idOf(what, t), idOf('textbook, both', t))));
  const trees = methods.filter(({ id }) => byPieces.has(id));
  const firsts = methods.filter(({ id }) => times.has(idOf(`${id}, first`, 'simd')));
  const { all, near } = operationsOfFirst();
  const passes = [0, 1, 2].map((k) => each(passId(k)));
  const pass = (k: number): string => nanoseconds((passes[k] as number) - (passes[k - 1] ?? 0));
  return [
    REASONS[0],
    '',
    `Written by \`npm run bench -- reasons\`, and by the ladder: typical rays in random order, ` +
      `${sample.shapes} shapes × ${sample.count} rays, processor time, medians and quartiles of ` +
      `${plan.rounds} rounds. Operations are those of a ray that hits a cone, both roots, ` +
      `counted in the program that both kernels are made of; for certified in the three passes ` +
      `of its first stage. Branches are those of the loop in TypeScript at most; that in ` +
      `WebAssembly asks them all at once.`,
    '',
    ...operationLines(methods),
    '',
    `One operation, in loops of ${PIECES} of a kind of which eight can be under way at once; a ` +
      `choice has its comparison in it:`,
    '',
    ...table(
      ['ns a ray', ...PIECE_IDS],
      TARGETS.map((target) => [
        NAMES[target],
        ...PIECE_IDS.map((piece) => (each(idOf(piece, target)) / PIECES).toPrecision(2)),
      ]),
    ),
    '',
    `Both roots, of the shapes that were drawn, if each operation took that, one kind after ` +
      `the other; and as they are measured. Where that is no longer, only fewer operations ` +
      `would make it less.`,
    '',
    ...table(
      ['ns a ray', ...TARGETS.flatMap((t) => [`${NAMES[t]}: by its operations`, 'measured'])],
      trees.map(({ id }) => [
        id,
        ...TARGETS.flatMap((target, k) => [
          id === 'textbook32' ? '–' : nanoseconds(byPieces.get(id)?.[k] ?? Number.NaN),
          nanoseconds(each(idOf(`${id}, both`, target))),
        ]),
      ]),
    ),
    '',
    `* To read the six arrays of a ray and write two answers takes of textbook's time ` +
      `${toTextbook('float64, reading')}; ` +
      `in float32, whose numbers are converted on their way in and out, since the arrays are of ` +
      `float64, ` +
      `${toTextbook('float32, reading')}. ` +
      `textbook32 takes ${spread(
        ratio(idOf('textbook32, both', 'simd'), idOf('textbook, both', 'simd')),
      )} in SIMD.`,
    `* stable without the order of its roots and the sign of q takes of textbook's time ` +
      `${toTextbook('stable, unordered')}; ` +
      `with an order by products with 0 and 1, which loses the sign of a zero, ` +
      `${toTextbook('stable, by products')}; ` +
      `as it is ` +
      `${toTextbook('stable, both')}.`,
    `* certified, both roots, in TypeScript, ns a ray: the rough roots ${pass(0)}, the residuals ` +
      `at both ${pass(1)}, the steps and their bounds ${pass(2)}; all stages ` +
      `${nanoseconds(each(idOf('certified, both', 'typescript')))}, textbook ` +
      `${nanoseconds(each(idOf('textbook, both', 'typescript')))}.`,
    `* textbook in SIMD takes ` +
      `${spread(ratio(idOf('textbook, both', 'simd'), idOf('textbook, both', 'typescript')))} of ` +
      `its time in TypeScript.`,
    '',
    `\`first\` of a batch finds both roots and chooses; exact alone solves the second root ` +
      `only where the first is out of the range. A loop that divides for one root has to know by ` +
      `signs which, and its quotient waits for them. It is made of the same trees here, and ` +
      `compared with \`first\` to the bit; its time is a ratio to that of \`first\`, though it ` +
      `does not even ask whether the other root is in range. The stages of certified answer a ` +
      `ray if the bounds of both of its roots hold: to know that, and the near root, takes ` +
      `${near} of the ${all} operations of the first stage.`,
    '',
    ...table(
      ['', ...TARGETS.flatMap((t) => [`${NAMES[t]}: first / both`, 'one root / first'])],
      firsts.map(({ id }) => [
        id,
        ...TARGETS.flatMap((t) => [
          spread(ratio(idOf(`${id}, first`, t), idOf(`${id}, both`, t))),
          spread(ratio(idOf(`${id}, one root`, t), idOf(`${id}, first`, t))),
        ]),
      ]),
    ),
    '',
    REASONS[1],
  ];
}

const NAMES: Readonly<Record<Target, string>> = { simd: 'SIMD', typescript: 'TypeScript' };
