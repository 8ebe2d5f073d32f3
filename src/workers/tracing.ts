import { accelerate } from '../math/accelerate.ts';
import { prepareTracer, type Tracer } from '../tracer/prepare.ts';
import { liveAs } from './life.ts';
import type { FromTraceWorker, ToTraceWorker } from './protocol.ts';

accelerate();
const living = liveAs(self.name);

/** The tracer of the last prepared scene. */
let ready: Promise<Tracer> = Promise.reject(new Error('no scene yet'));
ready.catch(() => {});

const clock = (): number => performance.now();

self.addEventListener('message', ({ data }: MessageEvent<ToTraceWorker>) => {
  answer(data).catch((error: unknown) => {
    const message = error instanceof Error ? error.message : 'the tracer failed';
    post({ type: 'failed', job: data.job, message });
  });
});

async function answer(asked: ToTraceWorker): Promise<void> {
  const { job } = asked;
  if (asked.type === 'scene') {
    const before = ready.catch(() => undefined);
    ready = living
      .then(() => before)
      .then((last) => prepareTracer(asked.scene, asked.settings, clock, last));
    const { parts } = await ready;
    post({ type: 'ready', job, effects: parts.map(({ id }) => id) });
    return;
  }
  const tracer = await ready;
  if (asked.type === 'record') {
    post({ type: 'tree', job, tree: tracer.record(asked.x, asked.y) });
    return;
  }
  const before = clock();
  const result = tracer.trace(asked.tile);
  const { pixels, rgba, surface, t, work, film } = result;
  const arrays = [pixels, rgba, surface, t, ...Object.values(work), ...(film ? [film] : [])];
  const owned = arrays.map(({ buffer }) => buffer as ArrayBuffer);
  post({ type: 'tile', job, result, ms: clock() - before }, owned);
}

function post(message: FromTraceWorker, owned: ArrayBuffer[] = []): void {
  self.postMessage(message, { transfer: owned });
}
