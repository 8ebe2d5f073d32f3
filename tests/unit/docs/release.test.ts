import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';
import { ROOT, read, SCRIPTS } from './documents.ts';

interface Dating {
  dated(text: string, version: string, date: string): string;
}
const SCRIPT = 'scripts/date-changelog.mjs';
const { dated }: Dating = await import(new URL(SCRIPT, ROOT).pathname);

const { version } = JSON.parse(read('package.json'));
const changelog = read('CHANGELOG.md');

describe('CHANGELOG.md', () => {
  test('has the version of package.json as its latest, and a date for each', () => {
    const parts = [...changelog.matchAll(/^## (.*)$/gm)].map(([, heading = '']) => heading);
    expect(parts[0]).toBe('Unreleased');
    expect(parts[1]?.split(' - ')[0]).toBe(version);
    for (const part of parts.slice(1)) expect(part).toMatch(/^\d+\.\d+\.\d+ - \d{4}-\d\d-\d\d$/);
  });

  test('groups its lines as Keep a Changelog does', () => {
    const groups = [...changelog.matchAll(/^### (.*)$/gm)].map(([, heading]) => heading);
    const known = ['Added', 'Changed', 'Deprecated', 'Removed', 'Fixed', 'Security'];
    expect(groups.filter((group) => !known.includes(group ?? ''))).toEqual([]);
  });
});

describe('dating it', () => {
  const text = '# Changelog\n\n## Unreleased\n\n### Added\n\n- x\n\n## 0.1.0 - 2026-11-22\n';

  test('puts what is unreleased under the version', () => {
    expect(dated(text, '0.2.0', '2027-01-02')).toBe(
      text.replace('## Unreleased\n', '## Unreleased\n\n## 0.2.0 - 2027-01-02\n'),
    );
  });

  test.each([
    ['where nothing is unreleased', text.replace('### Added\n\n- x\n', ''), '0.2.0'],
    ['where the version is there', text, '0.1.0'],
    ['without the heading', text.replace('## Unreleased', '## Next'), '0.2.0'],
  ])('is refused %s', (_, given, wanted) => {
    expect(() => dated(given, wanted, '2027-01-02')).toThrow(RangeError);
  });
});

test('npm version tests, dates the changelog, commits and tags', () => {
  const folder = mkdtempSync(join(tmpdir(), 'graze-release-'));
  const identity = Object.fromEntries(
    ['AUTHOR', 'COMMITTER'].flatMap((who) => [
      [`GIT_${who}_NAME`, 'Test'],
      [`GIT_${who}_EMAIL`, 'test@example.org'],
    ]),
  );
  const run = (command: string, ...args: string[]): string =>
    execFileSync(command, args, {
      cwd: folder,
      encoding: 'utf8',
      env: { ...process.env, ...identity },
      shell: process.platform === 'win32',
    });
  try {
    mkdirSync(join(folder, 'scripts'));
    copyFileSync(fileURLToPath(new URL(SCRIPT, ROOT)), join(folder, SCRIPT));
    // The project's scripts, of which the tests only leave a trace.
    const test = "node -e \"require('fs').writeFileSync('.git/tested', '')\"";
    const manifest = { name: 'graze', version: '0.1.0', scripts: { ...SCRIPTS, test } };
    writeFileSync(join(folder, 'package.json'), JSON.stringify(manifest));
    writeFileSync(join(folder, 'CHANGELOG.md'), '## Unreleased\n\n- x\n\n## 0.1.0 - 2026-11-22\n');
    run('git', 'init', '-q');
    run('git', 'add', '.');
    run('git', 'commit', '-qm', 'first');
    run('npm', 'version', 'minor');
    expect(readFileSync(join(folder, '.git/tested'), 'utf8')).toBe('');
    expect(run('git', 'tag').trim()).toBe('v0.2.0');
    expect(run('git', 'status', '--porcelain')).toBe('');
    expect(run('git', 'show', 'v0.2.0:CHANGELOG.md')).toMatch(
      /^## Unreleased\n\n## 0\.2\.0 - \d{4}-\d\d-\d\d\n\n- x\n/,
    );
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
