import type { RayTree } from '../../tracer/types.ts';
import type { FromTraceWorker, ToTraceWorker } from '../../workers/protocol.ts';
import type { WorkerLike } from '../../workers/trace-job.ts';
import type { TraceRequest } from './trace-request.ts';

export interface RayRecorder {
  /**
   * The rays of one pixel, by the same code that traces the picture; rejects with why it could not.
   */
  record(request: TraceRequest, x: number, y: number): Promise<RayTree>;
}

/**
 * A worker of its own follows the rays of single pixels: a picture under way need not stop for it.
 */
export function createRayRecorder(spawn: () => WorkerLike): RayRecorder {
  let worker: WorkerLike | null = null;
  let job = 0;
  let ready: string | null = null;
  let answer: ((message: FromTraceWorker) => void) | null = null;
  let last: Promise<unknown> = Promise.resolve();

  const open = (): WorkerLike => {
    if (worker) return worker;
    worker = spawn();
    worker.addEventListener('message', ({ data }) => {
      if (data.job === job) answer?.(data);
    });
    worker.addEventListener('error', ({ message = 'the worker failed' }) => {
      // The next request starts a new worker.
      worker?.terminate();
      worker = null;
      ready = null;
      answer?.({ type: 'failed', job, message });
    });
    return worker;
  };

  const ask = (message: ToTraceWorker): Promise<FromTraceWorker> =>
    new Promise((resolve, reject) => {
      answer = (data) => {
        answer = null;
        if (data.type === 'failed') reject(new Error(data.message));
        else resolve(data);
      };
      open().postMessage(message);
    });

  const recordNow = async ({ key, scene, settings }: TraceRequest, x: number, y: number) => {
    if (ready !== key) {
      ready = null;
      job += 1;
      await ask({ type: 'scene', job, scene, settings });
      ready = key;
    }
    const data = await ask({ type: 'record', job, x, y });
    if (data.type !== 'tree') throw new Error('no rays came back');
    return data.tree;
  };

  return {
    record(request, x, y) {
      // Requests run one after the other, since replies carry no request number.
      const next = last.then(() => recordNow(request, x, y));
      last = next.catch(() => null);
      return next;
    },
  };
}
