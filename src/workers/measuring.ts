import { answer } from '../lab/answer.ts';
import type { LabRequest } from '../lab/messages.ts';
import { accelerate, whyNotAccelerated } from '../math/accelerate.ts';
import { liveAs } from './life.ts';

/* Runs measurements in a worker, without pauses; the page terminates it to cancel. */

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
