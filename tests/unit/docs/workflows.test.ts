import { describe, expect, test } from 'vitest';
import { filesIn, npmScripts, read, SCRIPTS } from './documents.ts';

const WORKFLOWS = filesIn('.github/workflows/');

/** Jobs by name, each with its lines. */
function jobsOf(workflow: string): ReadonlyMap<string, string> {
  const [, jobs = ''] = workflow.split('\njobs:\n');
  const parts = jobs.split(/^ {2}(?=[\w-]+:\n)/m).filter((part) => /^[\w-]+:\n/.test(part));
  return new Map(parts.map((part) => [part.split(':')[0] ?? '', part]));
}

/** The commands of its steps, line by line. */
const commandsOf = (text: string): readonly string[] =>
  [...text.matchAll(/^ +(?:- )?run: (.*)$/gm)].map(([, command = '']) => command);

describe.each(WORKFLOWS)('%s', (path) => {
  const workflow = read(path);
  const jobs = [...jobsOf(workflow)];

  test('runs only scripts of package.json', () => {
    const named = npmScripts(commandsOf(workflow).join('\n'));
    expect(named.length).toBeGreaterThan(0);
    expect(named.filter((name) => !(name in SCRIPTS))).toEqual([]);
  });

  test('lets no job run without end', () => {
    expect(jobs.length).toBeGreaterThan(0);
    for (const [name, job] of jobs) {
      expect([name, /^ {4}timeout-minutes: \d+$/m.test(job)]).toEqual([name, true]);
    }
  });

  test('gives jobs no right but to read, unless they name it', () => {
    expect(workflow).toContain('\npermissions:\n  contents: read\n');
  });

  test('installs before it runs, with the cache of packages', () => {
    for (const [name, job] of jobs) {
      const [first = ''] = commandsOf(job);
      if (first === '') continue;
      expect([name, first]).toEqual([name, 'npm ci']);
      expect([name, job.includes('cache: npm')]).toEqual([name, true]);
    }
  });

  test('uses only actions of GitHub itself', () => {
    const used = [...workflow.matchAll(/uses: (\S+)/g)].map(([, action = '']) => action);
    expect(used.filter((action) => !/^actions\/[\w-]+@v\d+$/.test(action))).toEqual([]);
  });
});

describe('check.yml', () => {
  const check = read('.github/workflows/check.yml');

  test('has jobs that do not wait for each other', () => {
    expect([...jobsOf(check).keys()].sort()).toEqual(['browser', 'build', 'check', 'unit']);
    expect(check).not.toContain('needs:');
  });

  test('runs every shard of the browser tests', () => {
    const [, shards = ''] = /shard: \[(.*)\]/.exec(check) ?? [];
    const [, count = ''] = /--shard=\$\{\{ matrix\.shard \}\}\/(\d+)/.exec(check) ?? [];
    expect(shards.split(', ').map(Number)).toEqual(
      Array.from({ length: Number(count) }, (_, i) => i + 1),
    );
  });

  test('tries the oldest version of Node that package.json allows', () => {
    const { node } = JSON.parse(read('package.json')).engines;
    expect(check).toContain(`node: ['${node.replace('>=', '')}'`);
  });
});

test('deploy.yml puts the folder online that the build makes', () => {
  expect(read('.github/workflows/deploy.yml')).toContain('path: dist/site\n');
  expect(read('vite.config.ts')).toContain("'dist/site'");
});
