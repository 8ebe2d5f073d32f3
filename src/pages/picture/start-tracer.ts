import { late } from '../../ui/late.ts';
import { startWatched } from '../../workers/life.ts';
import type { WorkerLike } from '../../workers/trace-job.ts';

export type StartTracer = () => WorkerLike;

/**
 * How a tracer is started. One file that needs no other holds the worker inside; the site's own is
 * a file, and loads the effects' code when a scene needs it. Of the two imports a build keeps one.
 */
export async function loadTracer(): Promise<StartTracer> {
  const { default: TraceWorker } =
    import.meta.env.MODE === 'single'
      ? await late(() => import('../../workers/trace.ts?worker&inline'))
      : await late(() => import('../../workers/trace.ts?worker'));
  return () => startWatched((options) => new TraceWorker(options));
}
