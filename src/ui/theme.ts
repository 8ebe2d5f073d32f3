import { recall, remember } from './storage.ts';

export const THEMES = ['system', 'light', 'dark', 'projector'] as const;
export type Theme = (typeof THEMES)[number];

const KEY = 'graze.theme';

interface ThemeSwitch {
  current(): Theme;
  /** The theme in use; 'system' is resolved to light or dark. */
  applied(): Exclude<Theme, 'system'>;
  set(theme: Theme): void;
}

/** Follows the system's theme unless one was chosen; the choice is kept in local storage. */
export function watchTheme(root: HTMLElement, changed: () => void): ThemeSwitch {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const stored = recall(KEY) as Theme;
  let theme: Theme = THEMES.includes(stored) ? stored : 'system';
  const applied = (): Exclude<Theme, 'system'> =>
    theme === 'system' ? (dark.matches ? 'dark' : 'light') : theme;
  const apply = (): void => {
    root.dataset.theme = applied();
    changed();
  };
  dark.addEventListener('change', apply);
  apply();
  return {
    current: () => theme,
    applied,
    set(next) {
      theme = next;
      remember(KEY, next);
      apply();
    },
  };
}
