import type { LabReply, LabRequest, MapJob } from './messages.ts';
import type { Clock } from './run.ts';
import { measureSession } from './session.ts';
import { sweepSession } from './sweep.ts';

/** Least ms between two replies: redrawing the page takes time from what is being measured. */
const EVERY_MS = 100;

/**
 * Does the requested work and posts results as they come. An error becomes a reply, since a worker
 * that dies posts nothing. `whyNot` is for `measureSession`.
 */
export function answer(
  asked: Exclude<LabRequest, MapJob>,
  clock: Clock,
  post: (reply: LabReply) => void,
  whyNot: string | null = null,
): void {
  try {
    if (asked.type === 'measure') {
      let last = Number.NEGATIVE_INFINITY;
      for (const measured of measureSession(asked.request, clock, whyNot)) {
        const now = clock();
        if (now - last < EVERY_MS && !measured.complete) continue;
        last = now;
        post({ type: 'measured', measured });
      }
    } else {
      for (const point of sweepSession(asked.request)) post({ type: 'swept', point });
    }
    post({ type: 'done' });
  } catch (error) {
    post({ type: 'failed', message: error instanceof Error ? error.message : String(error) });
  }
}
