import { mkdirSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { accelerate } from '../../src/math/accelerate.ts';
import { METHODS } from '../../src/math/methods/index.ts';
import { body as heights } from '../../src/scene/effects/heights-body.ts';
import { coneOnMirror } from '../../src/scene/presets/cone-on-mirror.ts';
import { everything2 } from '../../src/scene/presets/everything-2.ts';
import { hundred } from '../../src/scene/presets/hundred.ts';
import { PRESETS } from '../../src/scene/presets/index.ts';
import type { Scene } from '../../src/scene/types.ts';
import { cameraAxes, fireCamera, pixelsOf } from '../../src/tracer/camera.ts';
import { createFinder } from '../../src/tracer/find.ts';
import { growthOf, numberOf, slopeOf, WITHIN } from '../../src/tracer/growth.ts';
import { newTally, totalOf } from '../../src/tracer/ledger.ts';
import { prepareTracer } from '../../src/tracer/prepare.ts';
import { DEFAULT_SETTINGS, type TileResult, type TraceSettings } from '../../src/tracer/types.ts';
import { createWave } from '../../src/tracer/wave.ts';
import { worldOf } from '../../src/tracer/world.ts';

/*
 * How many rays a second a picture takes, per preset and method; how its price grows, by the plan
 * and the names of the page (src/tracer/growth.ts); and where boxes pay. One thread. The best of a
 * few rounds of processor time: on a shared machine anything else measures the neighbours.
 * `--methods a,b` and `--presets a,b` choose.
 */
const ROUNDS = 3;

accelerate();

function clock(): number {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

function chosen<T extends { readonly id: string }>(
  option: string,
  all: readonly T[],
): readonly T[] {
  const at = process.argv.indexOf(option);
  const ids = at < 0 ? undefined : process.argv[at + 1]?.split(',');
  return ids ? all.filter(({ id }) => ids.includes(id)) : all;
}

const lines: string[] = [];
const print = (line: string): void => {
  console.log(line);
  lines.push(line);
};
const row = (cells: readonly (string | number)[]): void => print(`| ${cells.join(' | ')} |`);

interface Timed {
  readonly ms: number;
  readonly result: TileResult;
}

async function timed(scene: Scene, settings: Partial<TraceSettings>): Promise<Timed> {
  const all = { ...DEFAULT_SETTINGS, ...settings };
  const tracer = await prepareTracer(scene, all, () => performance.now());
  const tile = { y0: 0, y1: all.height, step: 1, refines: false };
  tracer.trace({ ...tile, step: 4 });
  let best = Number.POSITIVE_INFINITY;
  let result = tracer.trace(tile);
  for (let round = 0; round < ROUNDS; round++) {
    const before = clock();
    result = tracer.trace(tile);
    best = Math.min(best, clock() - before);
  }
  return { ms: best, result };
}

const raysOf = ({ result }: Timed): number => totalOf(result.ledger).rays;
const speed = (one: Timed): string => (raysOf(one) / one.ms / 1000).toFixed(2);

const methods = chosen('--methods', METHODS);
const presets = chosen('--presets', PRESETS);

print('# What a picture costs\n');
print(
  `Node ${process.version}, ${cpus()[0]?.model ?? 'unknown processor'}, one thread; ` +
    `processor time, the best of ${ROUNDS}.`,
);

print('\n## Million rays a second, 160 × 90\n');
row(['preset', `rays by ${methods[0]?.id}`, ...methods.map(({ id }) => id)]);
row(['---', '---', ...methods.map(() => '---')]);
for (const { id, scene } of presets) {
  const found: Timed[] = [];
  for (const { id: method } of methods) {
    found.push(await timed(scene, { method, width: 160, height: 90 }));
  }
  const [first] = found;
  row([id, first ? raysOf(first) : 0, ...found.map(speed)]);
}

for (const { scene } of [coneOnMirror, everything2]) {
  const settings = { ...DEFAULT_SETTINGS, width: 752, height: 424 };
  print(`\n## How the price grows: ${scene.title}, 752 × 424, certified\n`);
  print(
    `As on the page: linear is what a + b·x, logarithmic what a + b·log x meets within ` +
      `${100 * WITHIN} % at every point; constant, what varies by less; neither, the rest.\n`,
  );
  row(['number of', 'questions grow', 'time grows', 'from … to: questions, ms']);
  row(['---', '---', '---', '---']);
  for (const { id, title, how, points } of growthOf(scene, settings)) {
    const found: { x: number; questions: number; ms: number }[] = [];
    for (const { x, scene: own, settings: with_ } of points) {
      const one = await timed(own, with_);
      found.push({ x, questions: totalOf(one.result.ledger).questions, ms: one.ms });
    }
    const growth = (key: 'questions' | 'ms'): string => {
      const slope = slopeOf(found.map((one) => ({ x: one.x, y: one[key] })));
      return slope ? `${slope.growth}, slope ${slope.exponent.toFixed(2)}` : '–';
    };
    const cells = found.map(
      ({ x, questions, ms }) => `${numberOf(id, x)}: ${questions}, ${ms.toFixed(0)}`,
    );
    row([`${title} (${how})`, growth('questions'), growth('ms'), cells.join('; ')]);
  }
}

print('\n## Where boxes pay: nearest hits of 14,400 camera rays, ms\n');
row(['shapes', 'every shape asked', 'boxes']);
row(['---', '---', '---']);
for (const count of [1, 2, 4, 6, 8, 12, 25, 100]) {
  const scene = { ...hundred.scene, things: hundred.scene.things.slice(0, count + 1) };
  const { targets } = worldOf(scene, 'certified', 'needed');
  const settings = { ...DEFAULT_SETTINGS, width: 160, height: 90 };
  const wave = createWave(settings.width * settings.height);
  const pixels = pixelsOf({ y0: 0, y1: 90, step: 1, refines: false }, 160);
  fireCamera(cameraAxes(scene.camera, 16 / 9), settings, pixels, wave);
  const cells = [Number.POSITIVE_INFINITY, 0].map((least) => {
    const effect = { body: heights, clock: () => 0, spend: () => {} };
    const finder = createFinder(targets, { rule: 'from' }, effect, least);
    let best = Number.POSITIVE_INFINITY;
    for (let round = 0; round < 12; round++) {
      const before = clock();
      finder.nearest(wave, newTally());
      best = Math.min(best, clock() - before);
    }
    return best.toFixed(2);
  });
  row([count, ...cells]);
}

// A choice of rows is for looking at; the file holds all of them.
if (methods.length === METHODS.length && presets.length === PRESETS.length) {
  mkdirSync('docs', { recursive: true });
  writeFileSync('docs/bench-tracer.md', `${lines.join('\n')}\n`);
}
