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
 * A worker of the site's own file. A page without an origin, in a sandboxed frame, may start no
 * file but a text of its own, and in Chromium no module: a plain script that loads the module,
 * which the server has to let strangers have (Access-Control-Allow-Origin). What it is told until
 * then is kept for the module. Where that fails too the worker has an `error` event.
 */
export function moduleWorker(url: string, { name }: { name: string }): Worker {
  if (globalThis.origin !== 'null') return new Worker(url, { type: 'module', name });
  const file = JSON.stringify(new URL(url, location.href).href);
  const text = `
    const told = [];
    const keep = (event) => {
      event.stopImmediatePropagation();
      told.push(event);
    };
    addEventListener('message', keep);
    import(${file}).then(() => {
      removeEventListener('message', keep);
      for (const { data, ports } of told) {
        dispatchEvent(new MessageEvent('message', { data, ports }));
      }
    }, () => postMessage({ unstarted: true }));`;
  const own = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
  const worker = new Worker(own, { name });
  worker.addEventListener('message', (event: MessageEvent<{ unstarted?: true } | null>) => {
    if (!event.data?.unstarted) return;
    event.stopImmediatePropagation();
    worker.dispatchEvent(new ErrorEvent('error'));
  });
  return worker;
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
