import type { TreeRow } from '../../state/picture/tree-rows.ts';

/** ms from one ray to the next, and for all: a large tree plays faster, but not too fast. */
const EACH_MS = 1200;
const ALL_MS = 45_000;
const LEAST_MS = 250;

/** Plays the rays of a pixel one after another; later rays are not drawn yet. */
interface RayPlay {
  /** Path of the row that is played; null if all rays are there. */
  at(): string | null;
  runs(): boolean;
  /** ms until the next one. */
  pace(): number;
  /** Starts from the present ray, or from the first; or stops. */
  toggle(): void;
  /** One ray on or back; if none is present, the first or the last. */
  step(by: 1 | -1): void;
  /** Stops at this row. */
  seek(path: string): void;
  /** Ends play: all rays are drawn. */
  end(): void;
  /** Takes over the rows that are shown; with those of another tree it ends. */
  setRows(rows: readonly TreeRow[] | null): void;
}

/** A timer: calls `call` after `ms`, unless the returned function is called before. */
type Wait = (call: () => void, ms: number) => () => void;

const timed: Wait = (call, ms) => {
  const timer = setTimeout(call, ms);
  return () => clearTimeout(timer);
};

/** `moved` is called at each ray, and when it starts, stops or ends. Only a timer runs. */
export function createRayPlay(moved: () => void, later: Wait = timed): RayPlay {
  let rows: readonly TreeRow[] = [];
  let path: string | null = null;
  let stop: (() => void) | null = null;

  const index = (): number => rows.findIndex((row) => row.path === path);
  const pace = (): number => Math.max(LEAST_MS, Math.min(EACH_MS, ALL_MS / rows.length));
  const halt = (): void => {
    stop?.();
    stop = null;
  };
  const wait = (): void => {
    halt();
    stop = later(next, pace());
  };
  /** After the last one all of them stay. */
  function next(): void {
    const to = rows[index() + 1];
    halt();
    path = to?.path ?? null;
    if (to) wait();
    moved();
  }

  return {
    at: () => path,
    runs: () => stop !== null,
    pace,
    toggle() {
      if (stop !== null) halt();
      else if (rows.length > 0) {
        path ??= rows[0]?.path ?? null;
        wait();
      }
      moved();
    },
    step(by) {
      halt();
      const to = path === null ? (by === 1 ? 0 : rows.length - 1) : index() + by;
      // Before the first and after the last one is the whole tree.
      path = rows[to]?.path ?? null;
      moved();
    },
    seek(to) {
      halt();
      path = to;
      moved();
    },
    end() {
      halt();
      path = null;
    },
    setRows(next) {
      const isSame = next !== null && next[0]?.node === rows[0]?.node;
      rows = next ?? [];
      if (!isSame || index() < 0) this.end();
    },
  };
}
