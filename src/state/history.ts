import type { Action } from './actions.ts';
import type { AppState } from './state.ts';
import { update } from './update.ts';

/** The state with earlier ones for undo and later ones for redo. */
export interface History {
  readonly past: readonly AppState[];
  readonly present: AppState;
  readonly future: readonly AppState[];
  /**
   * The gesture of the last step; further actions of the same gesture are merged into that step.
   */
  readonly gesture: string | null;
}

/** Largest number of steps that can be undone. */
const LONGEST = 200;

/**
 * The parts of the state whose change is a step of undo. A change of view, bead, page or hidden
 * lines is none; undoing a step restores them as they were at that step.
 */
const UNDOABLE = [
  'kind',
  'shapes',
  'E',
  'd',
  'unit',
  'between',
  'caps',
  'typed',
  'method',
  'settings',
] as const satisfies readonly (keyof AppState)[];

export function historyOf(present: AppState): History {
  return { past: [], present, future: [], gesture: null };
}

/**
 * The history after an action. All actions of one gesture (a drag, a run of key presses) make one
 * step; with `gesture` null an action is a step of its own.
 */
export function advance(history: History, action: Action, gesture: string | null): History {
  if (action.type === 'undo') return back(history);
  if (action.type === 'redo') return forth(history);
  const { past, present } = history;
  const next = update(present, action);
  if (next === present) return history;
  if (sameStep(present, next)) return { ...history, present: next };
  const goesOn = gesture !== null && gesture === history.gesture;
  const before = past.at(-1);
  if (goesOn && before && sameValues(before, next)) {
    // A drag that was cancelled, or ended where it began, is no step.
    return { ...history, past: past.slice(0, -1), present: next, gesture: null };
  }
  return {
    past: goesOn ? past : [...past, present].slice(-LONGEST),
    present: next,
    future: [],
    gesture,
  };
}

function sameStep(a: AppState, b: AppState): boolean {
  return UNDOABLE.every((key) => a[key] === b[key]);
}

function sameValues(a: AppState, b: AppState): boolean {
  const values = (state: AppState): string => JSON.stringify(UNDOABLE.map((key) => state[key]));
  return values(a) === values(b);
}

function back({ past, present, future }: History): History {
  const before = past.at(-1);
  if (!before) return { past, present, future, gesture: null };
  return {
    past: past.slice(0, -1),
    present: restored(present, before),
    future: [{ ...present, page: before.page }, ...future],
    gesture: null,
  };
}

function forth({ past, present, future }: History): History {
  const after = future[0];
  if (!after) return { past, present, future, gesture: null };
  return {
    past: [...past, present],
    present: restored(present, after),
    future: future.slice(1),
    gesture: null,
  };
}

function restored(present: AppState, from: AppState): AppState {
  const { page, example } = from;
  const values = Object.fromEntries(UNDOABLE.map((key) => [key, from[key]]));
  return { ...present, ...values, page, example };
}
