import type { Action, Dispatch } from './actions.ts';
import { advance, historyOf } from './history.ts';
import type { AppState } from './state.ts';

export interface Store {
  get(): AppState;
  dispatch: Dispatch;
  canUndo(): boolean;
  canRedo(): boolean;
  subscribe(listener: (state: AppState) => void): () => void;
}

/**
 * One state, changed by actions only. Listeners are not called if an action changes nothing.
 * `gesture` names the drag or run of key presses in progress, which becomes one step of undo.
 */
export function createStore(initial: AppState, gesture: () => string | null = () => null): Store {
  let history = historyOf(initial);
  const listeners = new Set<(state: AppState) => void>();
  return {
    get: () => history.present,
    dispatch(action: Action) {
      const before = history.present;
      history = advance(history, action, gesture());
      if (history.present === before) return;
      for (const listener of listeners) listener(history.present);
    },
    canUndo: () => history.past.length > 0,
    canRedo: () => history.future.length > 0,
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
