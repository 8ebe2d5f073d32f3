/*
 * Notices a worker that crashes, mostly out of memory, which sends no event. The worker holds a Web
 * Lock; the page requests the same lock, and gets it when the worker is gone. This needs no timer,
 * so a long tile or a tab in the background is not taken for a crash. Without locks (a file opened
 * from disk, a host without TLS) a crash is not noticed.
 */

interface Alive {
  readonly alive: true;
}

/**
 * Takes the lock, in a worker with a unique name. Work without pauses has to wait for it, else a
 * crash would not be noticed.
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

/**
 * A worker of the site's own file. A page without an origin, in a sandboxed frame, may not start
 * one; in some browsers a text of its own may import the file. Where that is not allowed either,
 * the worker has an `error` event as any that cannot be started.
 */
export function moduleWorker(url: string, { name }: { name: string }): Worker {
  const options = { type: 'module', name } as const;
  try {
    return new Worker(url, options);
  } catch {
    const text = `import ${JSON.stringify(new URL(url, location.href).href)};`;
    const own = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
    return new Worker(own, options);
  }
}

/** Starts a worker that gets an `error` event with a message when it has crashed. */
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
