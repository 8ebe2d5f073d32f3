/*
 * What the device keeps of a page. Storage may be full, or denied: to files opened from disk, or by
 * a setting.
 */

let untold = (): void => {};
const failed = new Set<string>();

/** Whom to tell that something was not kept: once for each key. */
export function onNotKept(tell: () => void): void {
  untold = tell;
}

/** What the device remembers, or null. */
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
    // Then it lasts as long as the page.
    if (!failed.has(key)) untold();
    failed.add(key);
  }
}
