import { answer } from '../lab/answer.ts';
import type { LabRequest } from '../lab/messages.ts';
import { accelerate, whyNotAccelerated } from '../math/accelerate.ts';
import { liveAs } from './life.ts';

/*
 * The laboratory off the page's own thread: it may work without a pause, and is ended from outside.
 */

accelerate();
const living = liveAs(self.name);

addEventListener('message', async ({ data }: MessageEvent<LabRequest>) => {
  await living;
  answer(
    data,
    () => performance.now(),
    (reply) => postMessage(reply),
    whyNotAccelerated(),
  );
});
