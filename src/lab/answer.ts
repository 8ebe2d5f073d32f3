import type { LabReply, LabRequest } from './messages.ts';
import type { Clock } from './run.ts';
import { measureSession } from './session.ts';
import { sweepSession } from './sweep.ts';

/** A page that is drawn more often would take time from what is being measured. */
const EVERY_MS = 100;

/**
 * Does what was asked and posts what is found as it comes. An error becomes a reply: a worker that
 * dies says nothing. `whyNot` is for `measureSession`.
 */
export function answer(
  asked: LabRequest,
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
