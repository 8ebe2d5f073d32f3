export type Theme = 'system' | 'light' | 'dark';

const ORDER: readonly Theme[] = ['system', 'light', 'dark'];
const KEY = 'graze.theme';

export interface ThemeSwitch {
  current(): Theme;
  next(): void;
}

/** Follows the system unless the person chose; the choice stays on the device, where the device lets it. */
export function watchTheme(root: HTMLElement, changed: () => void): ThemeSwitch {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  let theme = remembered();
  const apply = (): void => {
    root.dataset.theme = theme === 'system' ? (dark.matches ? 'dark' : 'light') : theme;
    changed();
  };
  dark.addEventListener('change', apply);
  apply();
  return {
    current: () => theme,
    next() {
      theme = ORDER[(ORDER.indexOf(theme) + 1) % ORDER.length] ?? 'system';
      remember(theme);
      apply();
    },
  };
}

function remembered(): Theme {
  try {
    const found = localStorage.getItem(KEY) as Theme;
    return ORDER.includes(found) ? found : 'system';
  } catch {
    // Storage is denied to files opened from disk in some browsers.
    return 'system';
  }
}

function remember(theme: Theme): void {
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // Then it lasts as long as the page.
  }
}
