import type { Measured, MeasureRequest } from './session.ts';
import type { SweepPoint, SweepRequest } from './sweep.ts';

/** What the page asks of the worker; one job a worker, which is ended to cancel it. */
export type LabRequest =
  | { readonly type: 'measure'; readonly request: MeasureRequest }
  | { readonly type: 'sweep'; readonly request: SweepRequest };

/** What comes back. */
export type LabReply =
  | { readonly type: 'measured'; readonly measured: Measured }
  | { readonly type: 'swept'; readonly point: SweepPoint }
  | { readonly type: 'done' }
  | { readonly type: 'failed'; readonly message: string };
