import { prepareTracer, type Tracer } from '../../../src/tracer/prepare.ts';
import type { FromTraceWorker, ToTraceWorker } from '../../../src/workers/protocol.ts';
import type { WorkerLike } from '../../../src/workers/trace-job.ts';

/**
 * A worker of this thread: it traces when `step` is called, one message at a time, so that a test
 * decides the order.
 */
export interface FakeWorker extends WorkerLike {
  readonly inbox: ToTraceWorker[];
  readonly done: ToTraceWorker[];
  terminated: boolean;
  /** Answers the next message; false if there is none. */
  step(): Promise<boolean>;
  crash(message: string): void;
}

export function fakeWorker(): FakeWorker {
  let listen: (event: { readonly data: FromTraceWorker }) => void = () => {};
  let onError: (event: { readonly message?: string }) => void = () => {};
  let tracer: Tracer | undefined;
  const self: FakeWorker = {
    inbox: [],
    done: [],
    terminated: false,
    postMessage: (message) => void self.inbox.push(structuredClone(message)),
    addEventListener(type: 'message' | 'error', listener: never) {
      if (type === 'message') listen = listener;
      else onError = listener;
    },
    terminate() {
      self.terminated = true;
      self.inbox.length = 0;
    },
    crash: (message) => onError({ message }),
    async step() {
      const asked = self.inbox.shift();
      if (!asked) return false;
      self.done.push(asked);
      const { job } = asked;
      const say = (data: FromTraceWorker): void => {
        if (!self.terminated) listen({ data: structuredClone(data) });
      };
      if (asked.type === 'scene') {
        tracer = await prepareTracer(asked.scene, asked.settings, () => 0);
        say({ type: 'ready', job, effects: tracer.parts.map(({ id }) => id) });
      } else if (!tracer) say({ type: 'failed', job, message: 'no scene yet' });
      else if (asked.type === 'tile') {
        say({ type: 'tile', job, result: tracer.trace(asked.tile), ms: 1 });
      } else say({ type: 'tree', job, tree: tracer.record(asked.x, asked.y) });
      return true;
    },
  };
  return self;
}
