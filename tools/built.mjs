import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

export const here = (path) => fileURLToPath(new URL(path, import.meta.url));
export const root = here('..');

/** Installs what this folder's lockfile says, where nothing is there yet. */
export function installed() {
  if (existsSync(here('node_modules/typedoc'))) return;
  const argv = ['ci', '--ignore-scripts', '--no-audit', '--no-fund'];
  execFileSync('npm', argv, { cwd: here('.'), stdio: 'inherit' });
}

/** The folder of the package graze-math, built anew. */
export function built() {
  const folder = here('../test-results/graze-math');
  execFileSync(process.execPath, [here('../scripts/math-package/build.mjs'), folder], {
    cwd: root,
    stdio: ['ignore', 'ignore', 'inherit'],
  });
  return folder;
}
