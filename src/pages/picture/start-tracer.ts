import { lazy } from '../../ui/lazy.ts';
import { moduleWorker, startWatched } from '../../workers/life.ts';
import type { WorkerLike } from '../../workers/trace-job.ts';

export type StartTracer = () => WorkerLike;

/**
 * Loads the function that starts a tracing worker. The offline file holds the worker inline; on a
 * site it is a file, which loads an effect's code when a scene needs it. Of the two imports a build
 * keeps one.
 */
export async function loadTracer(): Promise<StartTracer> {
  if (import.meta.env.MODE === 'single') {
    const { default: Tracer } = await lazy(() => import('../../workers/trace.ts?worker&inline'));
    return () => startWatched((options) => new Tracer(options));
  }
  const { default: url } = await lazy(() => import('../../workers/trace.ts?worker&url'));
  return () => startWatched((options) => moduleWorker(url, options));
}
