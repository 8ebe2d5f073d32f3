import { lazy } from '../../ui/lazy.ts';
import { moduleWorker, startWatched } from '../../workers/life.ts';
import type { WorkerLike } from '../../workers/trace-job.ts';

export type StartTracer = () => WorkerLike;

/** How a tracer is started. The first `ahead` start at once, and load while the page is drawn. */
export async function loadTracer(ahead: number): Promise<StartTracer> {
  return startedAhead(await loadStart(), ahead);
}

/** Starts `count` workers at once, which are handed out first. */
export function startedAhead(start: StartTracer, count: number): StartTracer {
  const waiting = Array.from({ length: count }, () => {
    const one = { tracer: start(), failed: false };
    one.tracer.addEventListener('error', () => {
      one.failed = true;
    });
    return one;
  });
  return () => {
    const one = waiting.pop();
    if (!one?.failed) return one?.tracer ?? start();
    // Nobody has heard its error; that of another one will be heard.
    one.tracer.terminate();
    return start();
  };
}

/**
 * Loads the function that starts a tracing worker. The offline file holds the worker inline; on a
 * site it is a file, which loads an effect's code when a scene needs it. Of the two imports a build
 * keeps one.
 */
async function loadStart(): Promise<StartTracer> {
  if (import.meta.env.MODE === 'single') {
    const { default: Tracer } = await lazy(() => import('../../workers/trace.ts?worker&inline'));
    return () => startWatched((options) => new Tracer(options));
  }
  const { default: url } = await lazy(() => import('../../workers/trace.ts?worker&url'));
  return () => startWatched((options) => moduleWorker(url, options));
}
