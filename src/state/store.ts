import type { Action, Dispatch } from './actions.ts';
import type { AppState } from './state.ts';
import { update } from './update.ts';

export interface Store {
  get(): AppState;
  dispatch: Dispatch;
  subscribe(listener: (state: AppState) => void): () => void;
}

/** One state, changed by actions only; listeners hear of a change, not of an action that changed nothing. */
export function createStore(initial: AppState): Store {
  let state = initial;
  const listeners = new Set<(state: AppState) => void>();
  return {
    get: () => state,
    dispatch(action: Action) {
      const next = update(state, action);
      if (next === state) return;
      state = next;
      for (const listener of listeners) listener(state);
    },
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
