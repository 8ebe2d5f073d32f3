import type { MapPart } from './atlas/map.ts';
import type { Probe, ProbeRequest } from './atlas/probe.ts';
import type { MapRequest } from './atlas/request.ts';
import type { Measured, MeasureRequest } from './session.ts';
import type { SweepPoint, SweepRequest } from './sweep.ts';

/**
 * A request of the page to a worker. A worker measures once, and is terminated to cancel it; it
 * draws one map after the other, each of which ends the one before.
 */
export type LabRequest =
  | MapJob
  | { readonly type: 'measure'; readonly request: MeasureRequest }
  | { readonly type: 'sweep'; readonly request: SweepRequest };

/** A share of a map's pixels, or a closer look at some of them. */
export type MapJob =
  | {
      readonly type: 'map';
      /** By which replies to an earlier job are recognised. */
      readonly job: number;
      readonly request: MapRequest;
      readonly part: number;
      readonly parts: number;
    }
  | { readonly type: 'probe'; readonly job: number; readonly request: ProbeRequest };

/** What comes back. */
export type LabReply =
  | {
      readonly type: 'mapped';
      readonly job: number;
      readonly block: number;
      readonly part: MapPart;
    }
  | { readonly type: 'probed'; readonly job: number; readonly probe: Probe }
  | { readonly type: 'measured'; readonly measured: Measured }
  | { readonly type: 'swept'; readonly point: SweepPoint }
  | { readonly type: 'done' }
  | { readonly type: 'failed'; readonly message: string };
