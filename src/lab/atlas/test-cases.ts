import { intersect } from '../../math/index.ts';
import { shortest } from '../../text/format.ts';
import { type HardCase, hardCases } from '../hard-cases.ts';
import type { MapFrame } from './frame.ts';
import { markByte } from './marks.ts';
import { type MapRequest, raysOf } from './request.ts';
import { SIDE } from './window.ts';

/** Two opposite pixels of a rectangle, as columns and rows. */
type Corners = readonly [readonly [number, number], readonly [number, number]];

/** Most cases that are taken of a rectangle. */
const MOST_CASES = 200;

/**
 * Rays of a rectangle, evenly: the failing ones, or where none fails all of them. They are those
 * that the kernel gets.
 */
export function casesOf(
  request: MapRequest,
  frame: MapFrame,
  corners: Corners | null,
): readonly HardCase[] {
  const [[a, b], [c, d]] = corners ?? [
    [0, 0],
    [SIDE - 1, SIDE - 1],
  ];
  const all: number[] = [];
  for (let row = Math.min(b, d); row <= Math.max(b, d); row++) {
    for (let column = Math.min(a, c); column <= Math.max(a, c); column++) {
      all.push(row * SIDE + column);
    }
  }
  const marked = (pixel: number, mark: 'right' | 'nothing'): boolean =>
    frame.marks[pixel] === markByte(mark);
  const asked = all.filter((pixel) => !marked(pixel, 'nothing'));
  const failing = asked.filter((pixel) => !marked(pixel, 'right'));
  const rays = raysOf(request);
  return evenly(failing.length > 0 ? failing : asked, MOST_CASES).flatMap((pixel) => {
    const [column, row] = [pixel % SIDE, Math.floor(pixel / SIDE)];
    const found = rays.at(column, row);
    return found ? [{ id: `map/${column}-${row}`, family: 'map', ...found }] : [];
  });
}

/** At most so many of a list, evenly spread. */
function evenly(all: readonly number[], most: number): readonly number[] {
  if (all.length <= most) return all;
  return Array.from({ length: most }, (_, i) => all[Math.floor((i * all.length) / most)] ?? 0);
}

/** As `npm run cases` writes them. */
export const casesFile = (cases: readonly HardCase[]): string => hardCases(cases, 0);

/** As tests of the math module: classes are exact, roots one of the two doubles around. */
export function casesAsTests(cases: readonly HardCase[], from = './src/math/index.ts'): string {
  const lines = cases.map(({ id, shape, ray }) => {
    const { class: verdict, hits } = intersect(shape, ray, 'exact');
    const t = hits.map((hit) => hit.t);
    return `  ${literal({ id, shape, ray, class: verdict, t })},`;
  });
  return `import { expect, test } from 'vitest';
import { intersect, ulpDistance } from '${from}';

const CASES = [
${lines.join('\n')}
] as const;

test.each(CASES)('$id', ({ shape, ray, class: verdict, t }) => {
  const found = intersect(shape, ray);
  expect(found.class).toBe(verdict);
  expect(found.hits).toHaveLength(t.length);
  found.hits.forEach((hit, i) => expect(ulpDistance(hit.t, t[i]!)).toBeLessThanOrEqual(1));
});
`;
}

function literal(value: unknown): string {
  if (typeof value === 'number') return shortest(value);
  if (typeof value === 'string') return `'${value}'`;
  if (Array.isArray(value)) return `[${value.map(literal).join(', ')}]`;
  const entries = Object.entries(value as object);
  return `{ ${entries.map(([key, one]) => `${key}: ${literal(one)}`).join(', ')} }`;
}
