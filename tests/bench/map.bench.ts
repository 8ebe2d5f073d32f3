// What a map of 256 × 256 rays costs, certified's verdicts beside it included: by method and zoom,
// and by what its axes are. Processor time of one thread; the page has as many workers as cores.
import { axesOf, numberOn } from '../../src/lab/atlas/axes.ts';
import { mapOf } from '../../src/lab/atlas/frame.ts';
import type { MapRequest } from '../../src/lab/atlas/request.ts';
import { summaryOf } from '../../src/lab/atlas/summary.ts';
import { accelerate } from '../../src/math/accelerate.ts';
import { METHODS, type Ray, type Shape } from '../../src/math/index.ts';

const ROUNDS = 5;
const SHAPE: Shape = { kind: 'cone', vertex: [0, 3, 0], slope: 0.5 };
const RAY: Ray = { origin: [3, 1, 1], direction: [-0.8, -0.2, -0.3] };
/** Columns: how far the window is zoomed in. */
const WINDOWS = [
  { title: '10 lengths', measure: 'lengths', zoom: 0 },
  { title: '10⁻⁶ lengths', measure: 'lengths', zoom: 7 },
  { title: '256 doubles', measure: 'ulps', zoom: 13 },
] as const;
const AXES = [
  ['E.z', 'E.y'],
  ['E.z', 'd.x'],
  ['d.x', 'd.z'],
  ['E.z', 'c'],
  ['V.x', 'c'],
] as const;

const simd = accelerate();
console.log(`SIMD: ${simd ? 'yes' : 'no'}; ms of one thread, the best of ${ROUNDS} rounds\n`);
console.log(`| method | ${WINDOWS.map(({ title }) => title).join(' | ')} |`);
console.log(`|---|${WINDOWS.map(() => '---:|').join('')}`);
for (const { id } of METHODS) {
  const cells = WINDOWS.map(({ measure, zoom }) =>
    costOf(requestFor(['E.z', 'c'], { measure, zoom, method: id })),
  );
  console.log(`| ${id} | ${cells.join(' | ')} |`);
}
console.log(`\n| axes | textbook |\n|---|---:|`);
for (const axes of AXES) {
  const cost = costOf(requestFor(axes, { measure: 'lengths', zoom: 3, method: 'textbook' }));
  console.log(`| ${axes.join(', ')} | ${cost} |`);
}

function requestFor(
  axes: readonly [string, string],
  rest: Pick<MapRequest, 'measure' | 'zoom' | 'method'>,
): MapRequest {
  const at = (id: string): number => {
    const axis = axesOf(SHAPE).find((one) => one.id === id);
    return axis ? numberOn(axis, { shape: SHAPE, ray: RAY }) : Number.NaN;
  };
  return { shape: SHAPE, ray: RAY, unit: false, axes, at: [at(axes[0]), at(axes[1])], ...rest };
}

/** With the summary, which the page shows beside it. */
function costOf(request: MapRequest): string {
  let best = Number.POSITIVE_INFINITY;
  for (let round = 0; round < ROUNDS; round++) {
    const before = process.cpuUsage();
    summaryOf(request, mapOf(request));
    const { user, system } = process.cpuUsage(before);
    best = Math.min(best, (user + system) / 1000);
  }
  return best.toFixed(0);
}
