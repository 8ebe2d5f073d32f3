import type { Store } from '../../state/store.ts';

/** What of a hidden result is shown: lines, and the answer to an example's question. */
interface Shown {
  readonly lines: number;
  readonly told: boolean;
}

/**
 * A link with hidden results hides all of them, whoever opens it. What has been shown of them since
 * is kept in the entry of the browser's history, which outlives a reload and goes nowhere else.
 */
export function keepLines({ get, dispatch, subscribe }: Store): void {
  const before = kept();
  // Not over what the person has shown already.
  if (before && get().revealed === 0) dispatch({ type: 'reveal', lines: before.lines });
  if (before?.told) dispatch({ type: 'tell', on: true });
  subscribe(({ revealed, told }) => {
    const lines = revealed ?? 0;
    const now = kept();
    if (lines === (now?.lines ?? 0) && told === (now?.told ?? false)) return;
    try {
      history.replaceState({ ...history.state, shown: { lines, told } }, '');
    } catch {
      // A browser that counts these calls has had enough of them for now.
    }
  });
}

function kept(): Shown | null {
  const { lines, told } = history.state?.shown ?? {};
  return Number.isInteger(lines) && lines >= 0 ? { lines, told: told === true } : null;
}
