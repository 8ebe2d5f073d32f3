import type { Progress } from '../../check/progress.ts';
import { sessionStatements } from '../../state/course/session-statements.ts';
import { accountOf } from '../../state/course/xapi.ts';
import { download } from '../../ui/files.ts';
import { BROWSER_ENVIRONMENT } from './browser-environment.ts';
import { activityOf, setLink } from './set-link.ts';

/** Saves the statements of a session; the page answers between two questions. */
export async function saveStatements(
  progress: Progress,
  { seed, who }: { readonly seed: number; readonly who: string },
): Promise<void> {
  const activity = activityOf(setLink(progress.set, seed));
  const scene = { actor: accountOf(new URL('./', activity).href, who), activity };
  const all: unknown[] = [];
  for (const statements of sessionStatements(progress, scene, BROWSER_ENVIRONMENT)) {
    all.push(...statements);
    await new Promise((resolve) => setTimeout(resolve));
  }
  const text = `${JSON.stringify(all, null, 2)}\n`;
  download(`graze-statements-${progress.seed}.json`, text, 'application/json');
}
