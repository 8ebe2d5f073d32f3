import TraceWorker from '../../workers/trace.ts?worker';
import InlineTraceWorker from '../../workers/trace.ts?worker&inline';
import type { WorkerLike } from '../../workers/trace-job.ts';

/** One file that needs no other holds its worker inside; the site's own loads the effects' code when a scene needs it. */
export function spawnTracer(): WorkerLike {
  return import.meta.env.MODE === 'single' ? new InlineTraceWorker() : new TraceWorker();
}
