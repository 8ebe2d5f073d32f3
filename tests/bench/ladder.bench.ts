import { mkdirSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { batchesOf, rayAt, tasksOf } from '../../src/lab/plan.ts';
import { qualityOf } from '../../src/lab/quality.ts';
import { measure, type Times } from '../../src/lab/run.ts';
import { quantile, quartiles } from '../../src/lab/stats.ts';
import { FAMILIES, type Family } from '../../src/math/families.ts';
import { intersect } from '../../src/math/intersect.ts';
import type { Method } from '../../src/math/methods/define.ts';
import { METHODS } from '../../src/math/methods/index.ts';

/*
 * What each rung costs, as a ratio to the textbook batch on the same rays in the same round, and what it gets wrong. Rays are drawn from seed
 * 2026 in the order of their family (the mix: 99 % typical, 1 % hard, in random order). `--families a,b` measures only those.
 */
const SEED = 2026;
const SHAPES = 6;
const COUNT = 512;
const SAMPLE = { seed: SEED, shapes: SHAPES, count: COUNT };
const PLAN = { rounds: 15, least: 4, steps: 100, warmUp: 4 };
/** The processor's time of this process: on a shared machine the wall clock mostly measures the neighbours. */
function clock(): number {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

const chosen = process.argv[process.argv.indexOf('--families') + 1];
const families = process.argv.includes('--families')
  ? FAMILIES.filter(({ id }) => chosen?.split(',').includes(id))
  : FAMILIES;

const methods: readonly Method[] = METHODS.filter(({ batch }) => batch);
const lines: string[] = [];
const print = (line: string): void => {
  console.log(line);
  lines.push(line);
};

/** Ratios to textbook, round by round. */
function ratios(times: Times, id: string): string {
  const base = times.get('textbook') ?? [];
  const { low, median, high } = quartiles((times.get(id) ?? []).map((x, k) => x / (base[k] ?? 1)));
  return `${median.toFixed(2)} (${low.toFixed(2)}–${high.toFixed(2)})`;
}

function table(family: Family): void {
  const batches = batchesOf(family, SAMPLE);
  const rays = SHAPES * COUNT;
  const roots = measure(tasksOf(methods, batches, 'both'), clock, PLAN);
  const classes = measure(tasksOf(methods, batches, 'classes'), clock, PLAN);
  print(`\n### ${family.title}\n\n${family.idea}\n`);
  print(
    '| rung | both roots | ns | class only | ns | wrong class | undecided | ulps: 99.9 % | max |',
  );
  print('|---|---|---|---|---|---|---|---|---|');
  for (const method of methods) {
    const { wrong, undecided, ulps } = qualityOf(method, batches);
    const ns = (times: Times): string =>
      ((quartiles(times.get(method.id) ?? []).median / rays) * 1e6).toPrecision(3);
    const worst = ulps.at(-1) ?? 0;
    const cells = [
      method.id,
      ratios(roots, method.id),
      ns(roots),
      ratios(classes, method.id),
      ns(classes),
      `${wrong}`,
      `${undecided}`,
      ulps.length ? quantile(ulps, 0.999).toPrecision(3) : '–',
      ulps.length ? worst.toPrecision(3) : '–',
    ];
    print(`| ${cells.join(' | ')} |`);
  }
}

/** One ray at a time, as objects: t and class, which is what a caller who asks "where is it hit?" reads. */
function objects(): void {
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
    PLAN,
  );
  const ns = (id: string): string =>
    ((quartiles(times.get(id) ?? []).median / (SHAPES * COUNT)) * 1e6).toPrecision(3);
  print('\n### `intersect`, one typical ray at a time, input checked, t and class read\n');
  print(
    `textbook ${ns('textbook')} ns, certified ${ns('certified')} ns: ${ratios(times, 'certified')}`,
  );
  if (Number.isNaN(sum)) throw new Error('a root was not a number');
}

print('# What accuracy costs\n');
print(
  `Node ${process.version}, ${cpus()[0]?.model ?? 'unknown processor'}; seed ${SEED}, ${SHAPES} shapes × ${COUNT} rays a family, ${PLAN.rounds} interleaved rounds. Processor time, as ratios to the \`textbook\` batch on the same rays in the same round: median (quartiles). Ulps are counted from the correctly rounded root, for rays whose class is right.`,
);
objects();
for (const family of families) table(family);
mkdirSync('docs', { recursive: true });
writeFileSync('docs/bench.md', `${lines.join('\n')}\n`);
