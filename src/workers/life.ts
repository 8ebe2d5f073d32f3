/*
 * A worker that dies of itself, of its memory as a rule, sends no event. It holds a lock of its own
 * as long as it lives; the page queues for the same lock, and gets it when the worker is gone. That
 * needs no timer, so neither a long tile nor a tab in the background is taken for death. Without
 * locks (a file opened from disk, a host without TLS) nothing is noticed.
 */

interface Alive {
  readonly alive: true;
}

/**
 * In the worker, which was started under a name of its own. Work that never pauses waits for this,
 * or nothing is told.
 */
export function liveAs(name: string): Promise<void> {
  return new Promise((held) => {
    const locks = globalThis.navigator?.locks;
    if (!locks) return held();
    const hold = (): Promise<never> => {
      postMessage({ alive: true } satisfies Alive);
      held();
      return new Promise(() => {});
    };
    locks.request(name, hold).catch(() => held());
  });
}

/** Starts a worker that gets an `error` event, with words in it, when it has died. */
export function startWatched(start: (options: { name: string }) => Worker): Worker {
  // Pages of the same site share their locks.
  const name = `graze ${performance.timeOrigin} ${Math.random()}`;
  const worker = start({ name });
  const queue = new AbortController();
  worker.addEventListener('message', ({ data }: MessageEvent<Partial<Alive> | null>) => {
    if (!data?.alive) return;
    const died = (): void => {
      const message = 'a worker ended without a word; its memory may have run out. Try it again';
      worker.dispatchEvent(new ErrorEvent('error', { message }));
    };
    navigator.locks.request(name, { signal: queue.signal }, died).catch(() => {});
  });
  const terminate = worker.terminate.bind(worker);
  worker.terminate = () => {
    queue.abort();
    terminate();
  };
  return worker;
}
