import type { Measured, MeasureRequest } from './session.ts';
import type { SweepPoint, SweepRequest } from './sweep.ts';

/** A request of the page to a worker. A worker does one job, and is terminated to cancel it. */
export type LabRequest =
  | { readonly type: 'measure'; readonly request: MeasureRequest }
  | { readonly type: 'sweep'; readonly request: SweepRequest };

/** What comes back. */
export type LabReply =
  | { readonly type: 'measured'; readonly measured: Measured }
  | { readonly type: 'swept'; readonly point: SweepPoint }
  | { readonly type: 'done' }
  | { readonly type: 'failed'; readonly message: string };
