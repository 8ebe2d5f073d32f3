import { pageTruth } from '../fuzz/page-truth.ts';
import { prepare, randomUser } from '../fuzz/random-user.ts';
import { open } from './support/page.ts';
import { expect, test } from './support/test.ts';

test.use({ viewport: { width: 720, height: 540 }, hasTouch: true });

// Two users at once; `npm run fuzz:page -- --actions N --seed S` goes on for as long as wanted.
for (const seed of [11, 12]) {
  test(`1000 actions of a random user find nothing wrong (seed ${seed})`, async ({
    page,
    complaints,
  }) => {
    test.setTimeout(300_000);
    await prepare(page);
    await open(page, '#/explore');
    const user = { seed, actions: 1000, every: 20 };
    const result = await randomUser(page, user, () => pageTruth(page, complaints));
    expect(result.failure).toBeNull();
  });
}
