import { expect, test } from 'vitest';
import { createAnswers, packRays } from '../../../../src/math/batch/batch.ts';
import { STRAIGHT } from '../../../../src/math/batch/generated/index.ts';
import { inTypeScript, type Source, straightKernel } from '../../../../src/math/batch/straight.ts';
import { ASK, CLASS_BIT, type Loop } from '../../../../src/math/batch/straight-loop.ts';
import { FAMILIES } from '../../../../src/math/families.ts';
import { METHODS } from '../../../../src/math/methods/index.ts';
import { seeded } from '../../../../src/math/rng.ts';

/*
 * What a method's loops leave to the method itself costs many times a ray of theirs: a price would
 * be that of the leaving. So they settle every case distinction, in numbers of any usual size.
 */

/** Families in which D, A or N·d is often 0, and a sign unknown, in numbers of usual size. */
const SPECIAL = [
  ...['far-origin', 'near-tangent', 'near-tangent-far', 'exact-tangent', 'linear'],
  ...['generator', 'circle', 'sphere-whole', 'sphere-far', 'sphere-near-tangent'],
  ...['paraboloid-whole', 'paraboloid-far', 'paraboloid-near-tangent'],
];

/** The rays that a loop does not settle. */
function counting(tell: (asked: number, marked: number) => void): Source {
  const counted =
    (loop: Loop): Loop =>
    (numbers, rays, out, marked, roots) => {
      const left = loop(numbers, rays, out, marked, roots);
      const classes = Array.from(marked.subarray(0, left), (mark) => mark >>> CLASS_BIT);
      tell(classes.filter((place) => place === ASK).length, left);
      return left;
    };
  return (method, kind) => {
    const loops = inTypeScript(method, kind);
    return loops && { both: counted(loops.both), classes: counted(loops.classes) };
  };
}

test.each(Object.keys(STRAIGHT))('%s leaves no ray of usual size to its trees (seed 401)', (id) => {
  const method = METHODS.find((one) => one.id === id) as (typeof METHODS)[number];
  const random = seeded(401);
  let [asked, marked] = [0, 0];
  const source = counting((some, all) => {
    asked += some;
    marked += all;
  });
  for (const family of FAMILIES.filter((one) => SPECIAL.includes(one.id))) {
    for (let k = 0; k < 4; k++) {
      const { shape, rays } = family.batch(random, 40);
      const kernel = straightKernel(method, shape, source);
      expect(kernel, family.id).not.toBeNull();
      const out = createAnswers(rays.length);
      kernel?.both(packRays(rays), out);
      kernel?.classes(packRays(rays), out);
    }
  }
  expect(marked).toBeGreaterThan(0);
  expect(asked).toBe(0);
});
