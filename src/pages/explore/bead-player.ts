import type { GraphModel } from '../../state/graph-model.ts';

/** Duration of the whole interval of t, and of the pause at each root, in ms. */
const STRETCH_MS = 5000;
const REST_MS = 700;

export interface BeadPlayer {
  readonly playing: boolean;
  /** Starts from the beginning, or stops. */
  toggle(graph: GraphModel): void;
  stop(): void;
}

/**
 * Moves the bead along the ray with a pause at each root; with reduced motion it jumps from root to
 * root. `move` gets each t; `changed` is called when playing begins or ends.
 */
export function createBeadPlayer(move: (t: number) => void, changed: () => void): BeadPlayer {
  let frame = 0;
  const stop = (): void => {
    if (frame === 0) return;
    cancelAnimationFrame(frame);
    frame = 0;
    changed();
  };
  const run = (at: (elapsed: number) => number | null): void => {
    let begun: number | null = null;
    let shown = Number.NaN;
    const tick = (now: number): void => {
      begun ??= now;
      const t = at(now - begun);
      if (t === null) {
        stop();
        return;
      }
      frame = requestAnimationFrame(tick);
      if (t !== shown) move(t);
      shown = t;
    };
    frame = requestAnimationFrame(tick);
    changed();
  };
  return {
    get playing() {
      return frame !== 0;
    },
    toggle(graph) {
      if (frame !== 0) stop();
      else run(timetable(graph, matchMedia('(prefers-reduced-motion: reduce)').matches));
    },
    stop,
  };
}

/** t as a function of elapsed ms: evenly from E on, with a pause at each root; null at the end. */
function timetable(
  { from, to, roots }: Pick<GraphModel, 'from' | 'to' | 'roots'>,
  stepwise: boolean,
): (elapsed: number) => number | null {
  const start = from < 0 && to > 0 ? 0 : from;
  const stops = roots.map(({ t }) => t).filter((t) => t >= start && t <= to);
  if (stepwise) {
    const places = [start, ...stops, to];
    return (elapsed) => places[Math.floor(elapsed / (2 * REST_MS))] ?? null;
  }
  const speed = (to - start) / STRETCH_MS;
  return (elapsed) => {
    let left = elapsed;
    let t = start;
    for (const stop of stops) {
      const way = (stop - t) / speed;
      if (left < way) return t + left * speed;
      left -= way;
      t = stop;
      if (left < REST_MS) return t;
      left -= REST_MS;
    }
    const end = t + left * speed;
    return end > to ? null : end;
  };
}
