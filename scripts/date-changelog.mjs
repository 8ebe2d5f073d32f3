// npm runs this within `npm version`, after package.json has the new version and before the commit:
// what CHANGELOG.md has under "Unreleased" becomes that version's part, dated today.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const HEADING = '## Unreleased\n';

/** Throws RangeError where there is nothing to release, or a part of that version already. */
export function dated(text, version, date) {
  const [before, after, ...more] = text.split(HEADING);
  if (after === undefined || more.length > 0) {
    throw new RangeError(`CHANGELOG.md must have one heading "${HEADING.trim()}"`);
  }
  if (/^\s*(## |$)/.test(after)) throw new RangeError('nothing is unreleased in CHANGELOG.md');
  if (text.includes(`\n## ${version} `))
    throw new RangeError(`CHANGELOG.md has ${version} already`);
  return `${before}${HEADING}\n## ${version} - ${date}\n${after}`;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { version } = JSON.parse(readFileSync('package.json', 'utf8'));
  const date = new Date().toISOString().slice(0, 10);
  writeFileSync('CHANGELOG.md', dated(readFileSync('CHANGELOG.md', 'utf8'), version, date));
  execFileSync('git', ['add', 'CHANGELOG.md']);
}
