import type { LabReply, LabRequest } from './messages.ts';
import type { Clock } from './run.ts';
import { measureSession } from './session.ts';
import { sweepSession } from './sweep.ts';

/** Does what was asked and posts what is found as it comes. An error becomes a reply: a worker that dies says nothing. */
export function answer(asked: LabRequest, clock: Clock, post: (reply: LabReply) => void): void {
  try {
    if (asked.type === 'measure') {
      for (const measured of measureSession(asked.request, clock))
        post({ type: 'measured', measured });
    } else {
      for (const point of sweepSession(asked.request)) post({ type: 'swept', point });
    }
    post({ type: 'done' });
  } catch (error) {
    post({ type: 'failed', message: error instanceof Error ? error.message : String(error) });
  }
}
