import type { Measured, MeasureRequest } from '../../lab/session.ts';
import type { AccuracySettings } from '../../state/accuracy/settings.ts';
import { measureJob, type Spawn } from './lab-jobs.ts';
import { measureRequest, sameRays } from './requests.ts';

export interface Measuring {
  /** The most that is known of the rays of the settings; null before anything is. */
  readonly found: Measured | null;
  /** What runs now, or ran last. */
  readonly now: Measured | null;
  readonly running: boolean;
  readonly failed: string;
}

/**
 * Measures the rays of the settings: briefly by itself, once for each rays, when `mayStart` and the
 * page is at rest; longer when asked to. What was found stays until there is more of the same rays.
 */
export function createMeasuring(spawn: Spawn, changed: () => void, whenIdle = idle) {
  const job = measureJob(spawn, changed);
  let best: Measured | null = null;
  let planned: MeasureRequest | null = null;
  let wantsLonger = false;

  function start(request: MeasureRequest): void {
    planned = null;
    job.start(request);
  }

  /** The latest plan only: a dial that is dragged passes many rays. */
  function startWhenIdle(request: MeasureRequest): void {
    planned = request;
    whenIdle(() => {
      if (planned === request) start(request);
    });
  }

  return {
    /** What is known for these settings; starts or ends what they ask for. */
    update(settings: AccuracySettings, mayStart: boolean): Measuring {
      const request = measureRequest(settings, false);
      if (job.request && !sameRays(job.request, request)) {
        best = null;
        if (job.running) job.cancel();
      }
      if (!sameRays(planned, request)) planned = null;
      if (wantsLonger) start(measureRequest(settings, true));
      else if (mayStart && !planned && !sameRays(job.request, request)) startWhenIdle(request);
      wantsLonger = false;
      const now = sameRays(job.request, request) ? job.result : null;
      if (now && (now.round > 0 || !best)) best = now;
      return { found: best, now, running: job.running, failed: job.failed };
    },
    /** With the settings that are drawn next: they may have been changed since the last time. */
    longer(): void {
      wantsLonger = true;
      changed();
    },
    cancel: () => job.cancel(),
    /** Another page is shown. */
    rest(): void {
      planned = null;
      if (job.running) job.cancel();
    },
  };
}

/** ms without another wish, as between two steps of a dial. */
const PAUSE = 300;

function idle(act: () => void): void {
  setTimeout(() => {
    // Safari has none.
    if ('requestIdleCallback' in window) requestIdleCallback(act);
    else act();
  }, PAUSE);
}
