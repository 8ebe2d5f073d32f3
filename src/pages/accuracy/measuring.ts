import type { Measured, MeasureRequest } from '../../lab/session.ts';
import type { AccuracySettings } from '../../state/accuracy/settings.ts';
import { measureJob, type Spawn } from './lab-jobs.ts';
import { measureRequest, sameRays } from './requests.ts';

export interface Measuring {
  /** The most complete measurement of the rays of the settings; null without one. */
  readonly found: Measured | null;
  /** The running or the last measurement. */
  readonly now: Measured | null;
  readonly running: boolean;
  readonly failed: string;
}

/**
 * Measures the rays of the settings: once briefly by itself, as soon as `mayStart` is set and the
 * page is idle; longer on demand. A result is kept until there is a more complete one.
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

  /** Starts the latest request only, since a dragged dial makes many. */
  function startWhenIdle(request: MeasureRequest): void {
    planned = request;
    whenIdle(() => {
      if (planned === request) start(request);
    });
  }

  return {
    /** The result for these settings; starts and cancels measurements as they require. */
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
    /** Starts a longer measurement at the next `update`, which has the current settings. */
    longer(): void {
      wantsLonger = true;
      changed();
    },
    cancel: () => job.cancel(),
    /** Stops measuring, when another page is shown. */
    rest(): void {
      planned = null;
      if (job.running) job.cancel();
    },
  };
}

/** Pause in ms before a measurement starts; steps of a dragged dial are closer together. */
const PAUSE = 300;
/** Longest wait in ms for an idle page; on a busy machine the spread of the times shows it. */
const LONGEST_WAIT = 2000;

function idle(act: () => void): void {
  setTimeout(() => {
    // Safari has no requestIdleCallback.
    if ('requestIdleCallback' in window) requestIdleCallback(act, { timeout: LONGEST_WAIT });
    else act();
  }, PAUSE);
}
