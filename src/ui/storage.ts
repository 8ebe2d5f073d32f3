/*
 * The browser's local storage. It may be full, or denied: by a setting, or to files opened from
 * disk.
 */

let untold = (): void => {};
const failed = new Set<string>();

/** Sets a callback for values that could not be stored; called once for each key. */
export function onNotKept(tell: () => void): void {
  untold = tell;
}

/** The stored text of this key, or null. */
export function recall(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

export function remember(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
    failed.delete(key);
  } catch {
    // The value is then kept in memory, until the page is closed.
    if (!failed.has(key)) untold();
    failed.add(key);
  }
}
