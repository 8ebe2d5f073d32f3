import { pageTruth } from '../fuzz/page-truth.ts';
import { prepare, randomUser } from '../fuzz/random-user.ts';
import { open } from './support/page.ts';
import { expect, test } from './support/test.ts';

test.use({ viewport: { width: 720, height: 540 }, hasTouch: true });

// `npm run test:long` has a user who goes on for thousands of actions.
const ACTIONS = 30;

test(`${ACTIONS} actions of a random user find nothing wrong`, async ({ page, complaints }) => {
  await prepare(page);
  await open(page, '#/explore');
  const user = { seed: 11, actions: ACTIONS, every: 15 };
  const result = await randomUser(page, user, () => pageTruth(page, complaints));
  expect(result.failure).toBeNull();
});
