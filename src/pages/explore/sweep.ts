import type { Dispatch } from '../../state/actions.ts';
import { createDerive, type FullModel } from '../../state/derive.ts';
import { exploreDetails } from '../../state/explore-details.ts';
import { createSceneAndGraph } from '../../state/scene-and-graph.ts';
import { type AppState, shapeOf } from '../../state/state.ts';
import {
  playedAt,
  type Sweep,
  stepOfNumber,
  sweepOf,
  toNumber,
  valueAt,
  withNumber,
} from '../../state/sweep.ts';
import {
  frameBetween,
  graphIn,
  graphTrail,
  type SweepFrame,
  sceneTrail,
  sweepFrame,
} from '../../state/sweep-frame.ts';
import '../../ui/play-button.ts';
import './sweep.css';

/** Duration of the change to the frame that contains the whole sweep. */
const ROOM_MS = 300;

interface Playing {
  readonly sweep: Sweep;
  /** The state in which it plays; another ray or shape ends the sweep. */
  base: AppState;
  readonly held: SweepFrame | null;
  readonly own: SweepFrame;
  /** performance.now() at its start; null when it has stopped. */
  began: number | null;
  /** The value that is drawn. */
  value: number;
  seen: readonly [number, number];
}

/**
 * Plays a number of the ray or the shape (state/sweep.ts) with the trail of the roots. The state,
 * the link and undo stay as they are until an input stops the sweep: then the number gets the drawn
 * value, as one step of undo. With reduced motion the whole trail is shown at once. `changed` asks
 * for the next frame.
 */
export function createSweep(
  host: HTMLElement,
  changed: () => void,
  dispatch: Dispatch,
  announce: (words: string) => void,
): (model: FullModel) => FullModel {
  let playing: Playing | null = null;
  let latest: FullModel | null = null;
  /** The sweep to start with the next frame, after the action that stopped the one before. */
  let wanted: string | null = null;
  let fixed: SweepFrame['stage'] | null = null;
  const look = { ...exploreDetails, createSceneAndGraph: () => createSceneAndGraph(() => fixed) };
  const derive = createDerive(() => look);
  const isRunning = (): boolean => playing !== null && playing.began !== null;

  const tell = (): void => {
    host.toggleAttribute('data-playing', isRunning());
    for (const button of host.querySelectorAll<HTMLElement & { playing: boolean }>('graze-play'))
      button.playing = isRunning() && button.getAttribute('label') === playing?.sweep.label;
  };
  const start = (label: string, { state, shown, scene, graph }: FullModel): void => {
    const sweep = shown.hits ? sweepOf(state, label) : null;
    if (!sweep) return;
    announce(sweep.text);
    const { home, low, high } = sweep;
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    playing = {
      ...{ sweep, base: state, value: home },
      own: { stage: scene.stage, window: pick(graph) },
      held: still ? null : sweepFrame(state, sweep),
      began: still ? null : performance.now(),
      seen: still ? [low, high] : [home, home],
    };
  };
  /** Stops; the number keeps the drawn value. */
  const stop = (): void => {
    if (!playing || playing.began === null || !latest) return;
    playing.began = null;
    const { sweep, value } = playing;
    const there = withNumber(latest.state, sweep.label, value);
    const action = toNumber(latest.state, sweep.label, value);
    if (value !== sweep.home && there && action) {
      playing.base = there;
      dispatch(action);
    }
    tell();
    changed();
  };
  const toggle = (label: string): void => {
    if (!latest) return;
    const isSame = playing?.sweep.label === label;
    const wasRunning = isRunning();
    const hadStillTrail = isSame && playing?.held === null;
    stop();
    if (hadStillTrail) playing = null;
    else if (!(isSame && wasRunning)) wanted = label;
    tell();
    changed();
  };
  const end = (event: Event): void => {
    // A press on its own button is followed by a click, which stops it.
    const own = event.target instanceof Element ? event.target.closest('graze-play') : null;
    const isPress = !(event instanceof KeyboardEvent) || /^(Enter| )$/.test(event.key);
    if (!isPress || own?.getAttribute('label') !== playing?.sweep.label) stop();
  };
  for (const input of ['pointerdown', 'keydown', 'wheel', 'hashchange'])
    window.addEventListener(input, end, { capture: true, passive: true });
  host.addEventListener('graze-play', (event) => toggle((event as CustomEvent<string>).detail));

  return (model) => {
    latest = model;
    const { state, shown } = model;
    host.toggleAttribute('data-concealed', !shown.hits);
    if (playing && !(shown.hits && sameRay(playing.base, state))) {
      playing = null;
      tell();
    }
    if (wanted !== null) {
      start(wanted, model);
      wanted = null;
      tell();
    }
    if (!playing) return model;
    const { sweep, began, held, own } = playing;
    if (began !== null) {
      move(playing, valueAt(sweep, performance.now() - began), stepOfNumber(state, sweep.label));
      // Also after the last frame, which restores buttons and numbers.
      changed();
      tell();
    }
    const now = held && frameBetween(own, held, roomAt(playing));
    fixed = now?.stage ?? null;
    const there = isRunning() && withNumber(state, sweep.label, playing.value);
    const drawn: FullModel = there
      ? { ...derive(there), example: model.example, passing: true }
      : now
        ? { ...derive(state), example: model.example }
        : model;
    return withTrail(drawn, playing, now);
  };
}

/** Moves to a value; null at the end of the sweep. */
function move(playing: Playing, value: number | null, step: number): void {
  const { sweep, seen } = playing;
  if (value === null) {
    playing.began = null;
    playing.value = sweep.home;
    playing.seen = [sweep.low, sweep.high];
    return;
  }
  playing.seen = [Math.min(seen[0], value), Math.max(seen[1], value)];
  playing.value = playedAt(sweep, value, step);
}

const pick = ({ from, to, low, high }: FullModel['graph']): SweepFrame['window'] => ({
  ...{ from, to, low, high },
});

/** Share of the change to the frame of the sweep, 0 … 1. */
function roomAt({ began }: Playing): number {
  const share = began === null ? 1 : Math.min((performance.now() - began) / ROOM_MS, 1);
  return share * share * (3 - 2 * share);
}

function withTrail(
  model: FullModel,
  { sweep, seen, value }: Playing,
  held: SweepFrame | null,
): FullModel {
  const { scene, graph, state } = model;
  const trail = sceneTrail(sweep, seen, scene.stage);
  const window = held?.window ?? pick(graph);
  return {
    ...model,
    scene: {
      ...scene,
      figures: [...(scene.figures ?? []), ...trail],
      notes: [...scene.notes, sweep.text],
    },
    graph: {
      ...graphIn(graph, { window }, state, graphTrail(sweep, seen, value)),
      note: graph.note ?? `dots: the roots, larger ${sweep.label} above`,
    },
  };
}

const rayAndShape = (state: AppState): string =>
  JSON.stringify([state.kind, shapeOf(state), state.E, state.d, state.unit]);

const sameRay = (a: AppState, b: AppState): boolean => a === b || rayAndShape(a) === rayAndShape(b);
