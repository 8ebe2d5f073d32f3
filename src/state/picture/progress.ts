/** How much of a picture is traced, as the trace queue reports it. */
export interface Progress {
  readonly state: 'loading' | 'tracing' | 'finished' | 'cancelled' | 'failed';
  /** Pixels that are done, of how many. */
  readonly done: number;
  readonly total: number;
  /** Size in pixels of the blocks of the present pass; 1 for the last pass. */
  readonly step: number;
  readonly msSpent: number;
  /** Estimate; NaN while there is none. */
  readonly msLeft: number;
  readonly workers: number;
  /** Why it failed; '' otherwise. */
  readonly message: string;
}
