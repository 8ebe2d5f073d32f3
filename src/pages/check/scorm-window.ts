import type { ScormApi } from '../../state/course/scorm.ts';

/** Most windows that are looked at, upwards: a window may claim to be its own great-grandparent. */
const MOST_WINDOWS = 500;

interface FoundApi {
  readonly api: ScormApi | null;
  /** Whether a window was out of reach: of another origin. */
  readonly blocked: boolean;
}

/**
 * The object by which a course system speaks with a page, looked for as ADL says: in the windows
 * around this one, then in those around the one that opened it.
 */
export function findApi(name: string, start: Window): FoundApi {
  const around = upwards(name, start.parent === start ? null : start.parent);
  if (around.api) return around;
  const opened = [opener(start), opener(start.top)].map((one) => upwards(name, one));
  const found = opened.find(({ api }) => api);
  return found ?? { api: null, blocked: [around, ...opened].some(({ blocked }) => blocked) };
}

function opener(window: Window | null): Window | null {
  try {
    return (window?.opener as Window | null) ?? null;
  } catch {
    return null;
  }
}

function upwards(name: string, start: Window | null): FoundApi {
  let window = start;
  try {
    for (let i = 0; window && i < MOST_WINDOWS; i++) {
      const api: unknown = (window as unknown as Readonly<Record<string, unknown>>)[name];
      if (typeof api === 'object' && api !== null) return { api: api as ScormApi, blocked: false };
      window = window.parent === window ? null : window.parent;
    }
  } catch {
    return { api: null, blocked: true };
  }
  return { api: null, blocked: false };
}
