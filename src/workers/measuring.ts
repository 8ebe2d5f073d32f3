import { answer } from '../lab/answer.ts';
import { createMapServer } from '../lab/atlas/serve.ts';
import type { LabReply, LabRequest } from '../lab/messages.ts';
import { accelerate, whyNotAccelerated } from '../math/accelerate.ts';
import { liveAs } from './life.ts';

/* Measures in a worker, without pauses: the page terminates it to cancel. Draws maps piece by
   piece: the next one cancels. */

accelerate();
const living = liveAs(self.name);
const post = (reply: LabReply): void => postMessage(reply);
const channel = new MessageChannel();

/** Until messages that wait have been heard; a timer would wait for milliseconds. */
const pause = (): Promise<void> =>
  new Promise((done) => {
    channel.port1.onmessage = () => done();
    channel.port2.postMessage(null);
  });

const draw = createMapServer(post, pause);

addEventListener('message', async ({ data }: MessageEvent<LabRequest>) => {
  await living;
  if (data.type === 'map' || data.type === 'probe') return draw(data);
  answer(data, () => performance.now(), post, whyNotAccelerated());
});
