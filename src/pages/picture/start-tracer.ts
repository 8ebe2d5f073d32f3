import { late } from '../../ui/late.ts';
import { moduleWorker, startWatched } from '../../workers/life.ts';
import type { WorkerLike } from '../../workers/trace-job.ts';

export type StartTracer = () => WorkerLike;

/**
 * How a tracer is started. One file that needs no other holds the worker inside; the site's own is
 * a file, and loads the effects' code when a scene needs it. Of the two imports a build keeps one.
 */
export async function loadTracer(): Promise<StartTracer> {
  if (import.meta.env.MODE === 'single') {
    const { default: Tracer } = await late(() => import('../../workers/trace.ts?worker&inline'));
    return () => startWatched((options) => new Tracer(options));
  }
  const { default: url } = await late(() => import('../../workers/trace.ts?worker&url'));
  return () => startWatched((options) => moduleWorker(url, options));
}
