/** How far a picture has come; the driver of the workers says so. */
export interface Progress {
  readonly state: 'loading' | 'tracing' | 'finished' | 'cancelled' | 'failed';
  /** Pixels. */
  readonly done: number;
  readonly total: number;
  /** The size of the blocks: 1 when the finest pass runs. */
  readonly step: number;
  readonly msSpent: number;
  /** NaN while nobody can tell. */
  readonly msLeft: number;
  readonly workers: number;
  /** Why it failed; '' otherwise. */
  readonly message: string;
}
