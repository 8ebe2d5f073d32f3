import type { Store } from '../../state/store.ts';

/** How much of a hidden result has been revealed. */
interface RevealedLines {
  readonly lines: number;
  readonly told: boolean;
}

/**
 * Keeps the number of revealed lines over a reload: in the entry of the browser's history, since a
 * link with hidden results hides all of them.
 */
export function keepRevealed({ get, dispatch, subscribe }: Store): void {
  const before = kept();
  // Not if the person has revealed lines before this code was loaded.
  if (before && get().revealed === 0) dispatch({ type: 'reveal', lines: before.lines });
  if (before?.told) dispatch({ type: 'tell', on: true });
  subscribe(({ revealed, told }) => {
    const lines = revealed ?? 0;
    const now = kept();
    if (lines === (now?.lines ?? 0) && told === (now?.told ?? false)) return;
    try {
      history.replaceState({ ...history.state, shown: { lines, told } }, '');
    } catch {
      // Browsers limit the number of these calls in a time.
    }
  });
}

function kept(): RevealedLines | null {
  const { lines, told } = history.state?.shown ?? {};
  return Number.isInteger(lines) && lines >= 0 ? { lines, told: told === true } : null;
}
