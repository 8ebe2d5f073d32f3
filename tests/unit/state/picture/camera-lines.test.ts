import { describe, expect, test } from 'vitest';
import { LATEX, MATHML } from '../../../../src/math/formula.ts';
import { PRESETS } from '../../../../src/scene/presets/index.ts';
import type { Camera } from '../../../../src/scene/types.ts';
import { latexDisplay } from '../../../../src/state/exports/latex.ts';
import {
  cameraLines,
  cameraSteps,
  type PixelRay,
  writeLine,
} from '../../../../src/state/picture/camera-lines.ts';
import { TINY, tracerFor } from '../../tracer/tracing.ts';

const CAMERA: Camera = { eye: [0, 1, 4], target: [0, 1, 0], angle: 90 };
const RAY: PixelRay = {
  ...{ camera: CAMERA, width: 8, height: 4 },
  ...{ pixel: [5, 0], sample: 0, samples: 1 },
};

const dot = (a: readonly number[], b: readonly number[]): number =>
  a.reduce((sum, x, k) => sum + x * (b[k] ?? 0), 0);

describe.each(PRESETS)('$id: from the pixel to its ray', ({ scene }) => {
  test.each([1, 9])('%s rays a pixel: E and d are those that the tracer fires', async (samples) => {
    const tracer = await tracerFor(scene, { samples });
    for (const pixel of [
      [0, 0],
      [47, 26],
      [31, 9],
    ] as const) {
      tracer.record(pixel[0], pixel[1]).rays.forEach((node, sample) => {
        const ray = { ...RAY, ...TINY, camera: scene.camera, pixel, sample, samples };
        const { numbers, lines } = cameraSteps(ray);
        expect(numbers.vectors.E).toEqual(node.ray.origin);
        expect(lines.at(-1)).toMatchObject({ id: 'd', values: node.ray.direction });
        for (const { id, exprs, values } of lines) {
          expect([id, values.every(Number.isFinite)]).toEqual([id, true]);
          expect(values.length).toBe(exprs?.length ?? 1);
        }
      });
    }
  });

  test('what is said of the camera is true: lengths of 1, right angles, square pixels', () => {
    const { vectors, scalars } = cameraSteps({ ...RAY, camera: scene.camera }).numbers;
    const { g = [], s = [], w = [], R = [], U = [], F = [] } = vectors;
    for (const v of [g, s, w]) expect(Math.hypot(...v)).toBeCloseTo(1, 14);
    for (const [a, b] of [
      [g, s],
      [g, w],
      [s, w],
    ] as const)
      expect(dot(a, b)).toBeCloseTo(0, 14);
    expect([s[1], scalars.λ]).toEqual([0, expect.closeTo(Math.hypot(...F), 5)]);
    expect(dot(g, F)).toBeGreaterThan(0);
    expect(w[1]).toBeGreaterThanOrEqual(0);
    expect(Math.hypot(...R) / RAY.width).toBeCloseTo(Math.hypot(...U) / RAY.height, 14);
  });
});

test('u goes from −1 to 1 from the left, v from 1 at the top to −1', () => {
  const at = (pixel: readonly [number, number], sample: number) =>
    cameraSteps({ ...RAY, pixel, sample, samples: 4 }).numbers.scalars;
  const [u0, v0] = [-1 + 1 / 16, 1 - 1 / 8];
  expect(at([0, 0], 0)).toMatchObject({ u: u0, v: v0, i: 0, j: 0, n: 2 });
  expect(at([7, 3], 3)).toMatchObject({ u: -u0, v: -v0, i: 1, j: 1 });
  expect(cameraSteps(RAY).numbers.scalars).toMatchObject({ u: 0.375, v: 0.75 });
});

test('each line in symbols and numbers; half a pixel for one ray, a share of it for more', () => {
  const written = (ray: PixelRay, id: string): string => {
    const steps = cameraSteps(ray);
    const line = steps.lines.find((one) => one.id === id);
    if (!line) throw new Error(id);
    const { letter, symbols, numbers } = writeLine(line, steps, LATEX);
    return `${letter} = ${symbols} = ${numbers?.join('')}`;
  };
  expect(written(RAY, 'F')).toBe('F = T - E = (0, 1, 0) - (0, 1, 4)');
  expect(written(RAY, 'g')).toBe('g = \\frac{F}{\\lambda} = \\frac{(0, 0, -4)}{4}');
  expect(written(RAY, 'h')).toBe(
    'h = \\tan\\left(\\frac{\\alpha}{2}\\right) = \\tan\\left(\\frac{90^\\circ}{2}\\right)',
  );
  expect(written(RAY, 'u')).toBe('u = \\frac{2(x + 0.5)}{W} - 1 = \\frac{2(5 + 0.5)}{8} - 1');
  expect(written({ ...RAY, samples: 4, sample: 1 }, 'u')).toBe(
    'u = \\frac{2\\left(x + \\frac{i + 0.5}{n}\\right)}{W} - 1 = ' +
      '\\frac{2\\left(5 + \\frac{1 + 0.5}{2}\\right)}{8} - 1',
  );
  expect(written(RAY, 'D')).toContain('D = g + uR + vU = (0, 0, -1) + 0.375(');
  const down: Camera = { ...CAMERA, target: [0, 0, 4] };
  expect(written({ ...RAY, camera: down }, 's')).toBe('s = (1, 0, 0) = undefined');
});

test('it can be copied, with what is given', () => {
  const latex = latexDisplay('a pixel', cameraLines(RAY, LATEX));
  expect(latex).toContain('E &= (0, 1, 4)');
  expect(latex).toContain('\\alpha &= 90^\\circ');
  expect(latex).toMatch(/^% a pixel: .usepackage{amsmath}\n/);
  // Numbers in six digits give each of these values in six.
  expect(latex).not.toContain('\\approx');
  expect([...latex].every((c) => c.charCodeAt(0) < 128)).toBe(true);
  expect(cameraLines(RAY, MATHML).length).toBe(cameraLines(RAY, LATEX).length);
});
