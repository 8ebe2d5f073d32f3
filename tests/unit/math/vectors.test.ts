import { describe, expect, test } from 'vitest';
import { coefficients, intersect, SHAPES, solveQuadratic } from '../../../src/math/index.ts';
import { quadraticCases, rayCases, read, readAll, type VectorCase } from './read-vectors.ts';

const families = [...new Set(rayCases.map(({ family }) => family))];
const casesOf = (family: string): VectorCase[] => rayCases.filter((c) => c.family === family);

/** toEqual tells −0 from +0 (Object.is), so these comparisons are by bits. */
function answerOf({ shape, ray }: VectorCase) {
  const found = intersect(shape, ray, 'exact');
  return {
    class: found.class,
    roots: found.hits.map(({ t }) => t),
    points: found.hits.map(({ point }) => [...point]),
    normals: found.hits.map(({ normal }) => [...normal]),
    singular: found.hits.map(({ singular }) => singular),
  };
}

test('every shape that has families of its own has cases', () => {
  const kinds = new Set(rayCases.map(({ shape }) => shape.kind));
  const own = SHAPES.filter(({ ownFamilies }) => ownFamilies).map(({ kind }) => kind);
  expect(own.filter((kind) => !kinds.has(kind))).toEqual([]);
});

describe.each(families)('exact is bit-equal on %s', (family) => {
  test.each(casesOf(family).map((c) => [c.id, c] as const))('%s', (_, c) => {
    expect(answerOf(c)).toEqual({
      class: c.expect.class,
      roots: readAll(c.expect.roots),
      points: c.expect.points.map(readAll),
      normals: c.expect.normals.map(readAll),
      singular: [...c.expect.singular],
    });
    if (c.expect.coefficients) {
      const { A, B, C } = coefficients(c.shape, c.ray, 'exact');
      expect([A, B, C]).toEqual(readAll(c.expect.coefficients));
    }
  });
});

describe('what only curved or only flat shapes say of themselves', () => {
  test('the sign of D, and the degree', () => {
    for (const c of rayCases) {
      const { details } = intersect(c.shape, c.ray, 'exact');
      if (details.family !== 'curved') continue;
      const degree = details.signs.A ? 2 : details.signs.B ? 1 : 0;
      expect([c.id, degree, details.signs.D]).toEqual([
        c.id,
        c.expect.degree,
        c.expect.discriminantSign,
      ]);
    }
  });

  test('where the plane is met, and whether that is inside', () => {
    for (const c of rayCases) {
      const { details } = intersect(c.shape, c.ray, 'exact');
      if (details.family !== 'flat') continue;
      const t = c.expect.planeRoot === undefined ? null : read(c.expect.planeRoot);
      const inside = c.expect.inside ?? null;
      expect([c.id, details.plane?.t ?? null, details.plane?.inside ?? null]).toEqual([
        c.id,
        t,
        inside,
      ]);
    }
  });
});

describe('published quadratics', () => {
  test.each(quadraticCases.map((c, i) => [i, c.source, c] as const))('%i: %s', (_, __, c) => {
    const roots = readAll(c.roots);
    expect(solveQuadratic(c.A, c.B, c.C)).toEqual({
      class: c.class,
      // The files write a tangent's root twice where their source does.
      roots: c.class === 'tangent' ? roots.slice(0, 1) : roots,
    });
  });
});

describe.each(['textbook', 'stable'])(
  '%s agrees on the class where rays are ordinary',
  (method) => {
    test.each(['typical', 'plane', 'circle', 'square'])('%s', (family) => {
      const classes = (way: string) =>
        casesOf(family).map(({ id, shape, ray }) => [id, intersect(shape, ray, way).class]);
      expect(classes(method)).toEqual(casesOf(family).map((c) => [c.id, c.expect.class]));
    });
  },
);
