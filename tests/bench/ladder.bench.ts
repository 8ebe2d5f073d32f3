import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { dirname, join } from 'node:path';
import { batchesOf, rayAt, tasksOf } from '../../src/lab/plan.ts';
import { qualityOf } from '../../src/lab/quality.ts';
import { measure } from '../../src/lab/run.ts';
import { accelerate, decelerate } from '../../src/math/accelerate.ts';
import type { Kernel } from '../../src/math/batch/batch.ts';
import { batchOf } from '../../src/math/batch/kernels.ts';
import { FAMILIES, type Family } from '../../src/math/families.ts';
import { intersect } from '../../src/math/intersect.ts';
import { certified } from '../../src/math/methods/certified.ts';
import type { Method } from '../../src/math/methods/define.ts';
import { METHODS } from '../../src/math/methods/index.ts';
import type { Shape } from '../../src/math/shapes/index.ts';
import {
  betweenMarks,
  familyTable,
  headline,
  type Measured,
  nanoseconds,
  ratios,
} from './ladder-report.ts';

/*
 * What each method costs, as a ratio to the textbook batch on the same rays, and what it gets
 * wrong. Rays are drawn from seed 2026 in the order of their family (the mix: 99 % typical, 1 %
 * hard, in random order). Writes docs/bench.md, and its first table into the README; a smaller run,
 * by `--families a,b` or `--rounds 3`, writes both below test-results/ unless `--write` says
 * otherwise.
 */
const SEED = 2026;
const SHAPES = 6;
const COUNT = 512;
const SAMPLE = { seed: SEED, shapes: SHAPES, count: COUNT };

const option = (name: string): string | undefined => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? undefined : process.argv[at + 1];
};
const chosen = option('families');
const families = chosen ? FAMILIES.filter(({ id }) => chosen.split(',').includes(id)) : FAMILIES;
const rounds = Number(option('rounds') ?? 15);
if (!(rounds >= 1)) throw new RangeError(`--rounds must be at least 1, got ${option('rounds')}`);
const whole = (!chosen && rounds >= 15) || process.argv.includes('--write');
const PLAN = { rounds, least: 4, steps: 100, warmUp: 6 };
/**
 * Objects go through many more functions than a batch does: what the engine spends on compiling
 * them, in other threads of this process, is over by then.
 */
const OBJECT_PLAN = { ...PLAN, warmUp: 40 };

/**
 * The processor's time of this process: on a shared machine the wall clock mostly measures the
 * neighbours.
 */
function clock(): number {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

/** The same method where WebAssembly is missing. */
const plain: Method = { ...certified, id: 'certified, no WebAssembly' };

/** Without it between two calls of `accelerate`, which costs nothing the second time. */
function kernelOf(method: Method, shape: Shape): Kernel {
  if (method !== plain) return batchOf(method, shape);
  const kernel = batchOf(certified, shape);
  return {
    ...kernel,
    both(rays, out) {
      decelerate();
      kernel.both(rays, out);
      accelerate();
    },
  };
}
accelerate();
const methods: readonly Method[] = [...METHODS, plain];

function measured(family: Family): Measured {
  const batches = batchesOf(family, SAMPLE);
  return {
    family,
    roots: measure(tasksOf(methods, batches, 'both', kernelOf), clock, PLAN),
    classes: measure(tasksOf(methods, batches, 'classes', kernelOf), clock, PLAN),
    quality: new Map(methods.map((method) => [method.id, qualityOf(method, batches, kernelOf)])),
    rays: SHAPES * COUNT,
  };
}

/**
 * One ray at a time, as objects: t and class, which is what a caller who asks "where is it hit?"
 * reads.
 */
function objects(): string[] {
  const typical = FAMILIES.find(({ id }) => id === 'typical') as Family;
  const asked = batchesOf(typical, SAMPLE).map((batch) => ({
    shape: batch.shape,
    rays: Array.from({ length: batch.rays.count }, (_, i) => rayAt(batch, i)),
  }));
  let sum = 0;
  const byTextbook = (): void => {
    for (const { shape, rays } of asked) {
      for (const ray of rays) {
        const { hits } = intersect(shape, ray, 'textbook');
        for (let k = 0; k < hits.length; k++) sum += hits[k]?.t ?? 0;
      }
    }
  };
  const byCertified = (): void => {
    for (const { shape, rays } of asked) {
      for (const ray of rays) {
        const { hits } = intersect(shape, ray, 'certified');
        for (let k = 0; k < hits.length; k++) sum += hits[k]?.t ?? 0;
      }
    }
  };
  const times = measure(
    [
      { id: 'textbook', run: byTextbook },
      { id: 'certified', run: byCertified },
    ],
    clock,
    OBJECT_PLAN,
  );
  if (Number.isNaN(sum)) throw new Error('a root was not a number');
  const ns = (id: string): string => nanoseconds(times, id, SHAPES * COUNT);
  return [
    '### `intersect`, one typical ray at a time, input checked, t and class read',
    '',
    `textbook ${ns('textbook')} ns, certified ${ns('certified')} ns: ${ratios(times, 'certified')}`,
    '',
  ];
}

const lines: string[] = [];
const print = (more: readonly string[]): void => {
  console.log(more.join('\n'));
  lines.push(...more);
};

const about = [
  '# What accuracy costs',
  '',
  `Node ${process.version}, ${cpus()[0]?.model ?? 'unknown processor'}; seed ${SEED}, ${SHAPES} shapes × ${COUNT} rays a family, ${rounds} interleaved rounds. Processor time of the best round, as ratios to that of the \`textbook\` batch on the same rays (quartiles of the ratios round by round). Ulps are counted from the correctly rounded root, for rays whose class is right. \`certified\` has its roots of batches by WebAssembly (src/math/accelerate.ts) and, in the last row, by TypeScript alone: the same roots to the bit. Written by \`npm run bench -- ladder\`.`,
  '',
];
print(objects());
const all = families.map((family) => {
  const one = measured(family);
  print(familyTable(one));
  return one;
});
const first = headline(all);
console.log(first.join('\n'));
const into = (path: string): string => {
  const file = whole ? path : join('test-results', path);
  mkdirSync(dirname(file), { recursive: true });
  return file;
};
writeFileSync(into('docs/bench.md'), [...about, ...first, '', ...lines].join('\n'));
writeFileSync(into('README.md'), betweenMarks(readFileSync('README.md', 'utf8'), first));
