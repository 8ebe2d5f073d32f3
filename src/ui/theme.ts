import { recall, remember } from './storage.ts';

export const THEMES = ['system', 'light', 'dark', 'projector'] as const;
export type Theme = (typeof THEMES)[number];

const KEY = 'graze.theme';

interface ThemeSwitch {
  current(): Theme;
  /** The theme in use; 'system' is resolved to light or dark. */
  applied(): Exclude<Theme, 'system'>;
  set(theme: Theme): void;
  /** The theme that a link asks for; what the person sets later counts more. */
  ask(theme: Theme | null): void;
}

/** Follows the system's theme unless one was chosen; the choice is kept in local storage. */
export function watchTheme(root: HTMLElement, changed: () => void): ThemeSwitch {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const stored = recall(KEY) as Theme;
  let theme: Theme = THEMES.includes(stored) ? stored : 'system';
  let asked: Theme | null = null;
  let isSet = false;
  const current = (): Theme => (isSet ? theme : (asked ?? theme));
  const applied = (): Exclude<Theme, 'system'> => {
    const now = current();
    return now === 'system' ? (dark.matches ? 'dark' : 'light') : now;
  };
  const apply = (): void => {
    root.dataset.theme = applied();
    changed();
  };
  dark.addEventListener('change', apply);
  apply();
  return {
    current,
    applied,
    set(next) {
      theme = next;
      isSet = true;
      remember(KEY, next);
      apply();
    },
    ask(next) {
      if (next === asked) return;
      asked = next;
      isSet = false;
      apply();
    },
  };
}
