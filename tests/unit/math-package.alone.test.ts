import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { build } from 'vite';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { SHAPES } from '../../src/math/index.ts';
import { ROOT } from './docs/documents.ts';

/*
 * `npm run build:math` as somebody has it who installs it: packed, installed into an empty project
 * without a network, and used from there.
 */

/** Ten times what it takes alone. */
const PATIENCE_MS = 100_000;

const project = mkdtempSync(join(tmpdir(), 'graze-math-'));
const root = new URL('.', ROOT).pathname;
const run = (file: string, argv: readonly string[], cwd = project): string =>
  execFileSync(file, argv, { cwd, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
const node = (argv: readonly string[], cwd?: string): string => run(process.execPath, argv, cwd);

beforeAll(() => {
  const out = join(project, 'built');
  node([join(root, 'scripts/math-package/build.mjs'), out]);
  const [{ filename }] = JSON.parse(run('npm', ['pack', '--json', out]));
  writeFileSync(join(project, 'package.json'), '{ "type": "module", "private": true }');
  run('npm', ['install', '--offline', '--no-audit', '--no-fund', `./${filename}`]);
  rmSync(out, { recursive: true });
}, PATIENCE_MS);

afterAll(() => rmSync(project, { recursive: true, force: true }));

const installed = (path: string): string =>
  readFileSync(join(project, 'node_modules/graze-math', path), 'utf8');

const PROGRAM = `
import { accelerate, decelerate } from 'graze-math/accelerate';
import { batchOf, createAnswers, packRays } from 'graze-math/batch';
import { findFamily, seeded } from 'graze-math/families';
import { evaluate, exact, num } from 'graze-math/formula';
import { intersect, METHODS, prepare, prepareWith, sphere } from 'graze-math';

const ray = { origin: [-10, 0, 3], direction: [1, 0, 0] } as const;
const cylinder = { kind: 'cylinder', center: [0, 0, 0], radius: 5 } as const;
const said: unknown[] = [intersect(cylinder, ray).hits.map(({ t }) => t)];
said.push(prepare({ ...cylinder, between: [-1, 1] }, { tMin: 7 }).first(ray)?.fate);
const ball = { kind: 'sphere', center: new Float64Array([0, 0, 3]), radius: 1 } as const;
said.push(prepareWith(sphere)(ball).any(ray));
const certified = METHODS.find(({ id }) => id === 'certified');
if (!certified) throw new Error('no certified');
const out = createAnswers(1);
batchOf(certified, cylinder).both(packRays([ray]), out);
said.push(out.t1[0], accelerate());
decelerate();
said.push(findFamily('exact-tangent')?.batch(seeded(7), 3).rays.length);
said.push(exact.toNumber(evaluate(num(2), exact, { scalars: {}, vectors: {} })));
console.log(JSON.stringify(said));
`;

const SAID = [[6, 14], 'hit', true, 14, true, 3, 2];

const STRICT = {
  ...{ target: 'ES2022', lib: ['ES2022', 'DOM'], types: [], strict: true, skipLibCheck: false },
  ...{ noUncheckedIndexedAccess: true, exactOptionalPropertyTypes: true, isolatedModules: true },
};

test.each([
  ['node16', 'node16'],
  ['esnext', 'bundler'],
])('a strict tsc takes its types: module %s, resolution %s', (module, moduleResolution) => {
  const folder = join(project, moduleResolution);
  mkdirSync(folder);
  writeFileSync(join(folder, 'program.ts'), PROGRAM);
  const compilerOptions = { ...STRICT, module, moduleResolution };
  writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify({ compilerOptions }));
  node([join(root, 'node_modules/typescript/bin/tsc')], folder);
  expect(JSON.parse(node(['program.js'], folder))).toEqual(SAID);
});

interface Chunk {
  readonly code?: string;
}

/** A bundle of what `code` imports, minified, as a page would have it. */
async function bundled(code: string, minify = true): Promise<string> {
  const input = join(project, 'bundled.js');
  writeFileSync(input, code);
  const result = await build({
    root: project,
    configFile: false,
    logLevel: 'error',
    build: {
      write: false,
      minify,
      target: 'es2022',
      modulePreload: false,
      rolldownOptions: { input, preserveEntrySignatures: 'strict', output: { format: 'es' } },
    },
  });
  const { output } = result as unknown as { readonly output: readonly Chunk[] };
  return output.map((chunk) => chunk.code ?? '').join('');
}

test('runs from a bundle', async () => {
  const program = PROGRAM.replaceAll(' as const', '').replace(': unknown[]', '');
  writeFileSync(join(project, 'bundle.mjs'), await bundled(program));
  expect(JSON.parse(node(['bundle.mjs']))).toEqual(SAID);
});

describe('a bundle holds what is imported, minified and packed in at most as many bytes', () => {
  const curved = SHAPES.filter(({ numbers }) => numbers?.family !== 'planar');

  test.each([
    ['ulpDistance', 1000],
    ['solveQuadratic', 8000],
    ...curved.map(({ kind }) => [`prepareWith, ${kind}`, 20_000] as const),
  ] as const)('%s: %i', async (names, most) => {
    const code = await bundled(`export { ${names} } from 'graze-math';`);
    expect(gzipSync(code, { level: 9 }).length).toBeLessThanOrEqual(most);
  });
});

describe('its command', () => {
  const command = (...argv: string[]): string => run('npx', ['--offline', 'graze-cases', ...argv]);

  test('writes cases with exact answers', () => {
    const { cases, seed } = JSON.parse(command('--family', 'vertex,typical', '--count', '3'));
    expect(cases.map(({ id }: { id: string }) => id).at(-1)).toBe('typical/3');
    expect(seed).toBe(1);
    command('--family', 'far-origin', '--float32', '--out', 'far.json');
    const far = JSON.parse(readFileSync(join(project, 'far.json'), 'utf8'));
    expect(far.float32).toBe(true);
    for (const { ray } of far.cases) {
      expect(ray.origin.map(Math.fround)).toEqual(ray.origin);
    }
  });

  test.each([
    ['python', 'run_cases.py'],
    ['cpp', 'graze_cases.hpp'],
    ['rust', 'graze_cases.rs'],
    ['glsl', 'graze_cases.html'],
  ])('puts the runner for %s beside them', (name, file) => {
    expect(command('--runner', name).trim()).toBe(file);
    const own = readFileSync(join(root, 'scripts/cases', file), 'utf8');
    expect(readFileSync(join(project, file), 'utf8')).toBe(own);
  });

  test('says what it takes, and what is wrong', () => {
    expect(command('--help')).toContain('--runner');
    expect(() => command('--runner', 'basic')).toThrow(/no runner 'basic'/);
    expect(() => command('--count', 'x')).toThrow(/--count must be a whole number/);
  });
});

/** The functions of the package that run while a door is imported, as V8 counts them. */
function runAtImport(door: string): readonly string[] {
  const counts = mkdtempSync(join(project, 'counts-'));
  execFileSync(process.execPath, ['--input-type=module', '-e', `import 'graze-math${door}';`], {
    cwd: project,
    env: { ...process.env, NODE_V8_COVERAGE: counts },
  });
  const [file = ''] = readdirSync(counts);
  const { result } = JSON.parse(readFileSync(join(counts, file), 'utf8'));
  const modules = result.filter(({ url }: { url: string }) => url.includes('/graze-math/lib/'));
  expect(modules.length).toBeGreaterThan(0);
  // The first of each is the module itself.
  return modules.flatMap(({ functions }: { functions: readonly Counted[] }) =>
    functions
      .slice(1)
      .flatMap(({ functionName, ranges: [all] }) => (all.count > 0 ? [functionName] : [])),
  );
}

interface Counted {
  readonly functionName: string;
  readonly ranges: readonly [{ readonly count: number }];
}

const DOORS = ['', '/batch', '/accelerate', '/formula', '/families'];

/* What each module is written with is held by tests/unit/architecture.test.ts. */
describe('what is done when it is imported', () => {
  test.each(DOORS)('graze-math%s: nothing runs but `lazily`, which makes a function', (door) => {
    // An object that a class keeps, as a literal, V8 counts as a function of the class.
    const allowed = ['lazily', '<static_initializer>'];
    expect(runAtImport(door).filter((name) => !allowed.includes(name))).toEqual([]);
  });

  test.each(SHAPES.map(({ kind }) => kind))('%s: no other shape comes with it', async (kind) => {
    const code = await bundled(`export { prepareWith, ${kind} } from 'graze-math';`, false);
    const brought = SHAPES.filter(({ icon }) => code.includes(icon));
    expect(brought.map((one) => one.kind)).toEqual([kind]);
  });

  test.each(DOORS)('graze-math%s: no array, no map and no WebAssembly', (door) => {
    writeFileSync(join(project, 'watch.mjs'), watching(door));
    expect(JSON.parse(node(['watch.mjs']))).toEqual([]);
  });
});

/** A program that imports a door, and says what is made by that. */
const watching = (door: string): string => `
const made = [];
const watched = (owner, name) => {
  owner[name] = new Proxy(owner[name], {
    construct(target, argv, self) {
      made.push(name);
      return Reflect.construct(target, argv, self);
    },
  });
};
for (const name of ['Float64Array', 'Float32Array', 'Int32Array', 'Uint8Array', 'ArrayBuffer'])
  watched(globalThis, name);
for (const name of ['DataView', 'Map', 'Set', 'WeakMap', 'RegExp']) watched(globalThis, name);
for (const name of ['Module', 'Instance', 'Memory']) watched(WebAssembly, name);
await import('graze-math${door}');
console.log(JSON.stringify(made));
`;

describe('what it says of itself', () => {
  const about = (): Record<string, unknown> => JSON.parse(installed('package.json'));

  test('no dependency, no side effects, the version of Graze, and every door a file', () => {
    const { version } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
    expect(about()).toMatchObject({ name: 'graze-math', version, sideEffects: false });
    for (const field of ['dependencies', 'peerDependencies', 'scripts', 'private']) {
      expect(about()).not.toHaveProperty(field);
    }
    const doors = Object.values(about().exports as Record<string, Record<string, string> | string>);
    for (const file of doors.flatMap((door) =>
      typeof door === 'string' ? door : Object.values(door),
    ))
      expect(installed(file)).not.toBe('');
  });

  test('its documents lead to files that are there, and import it by its own name', () => {
    for (const name of ['README.md', 'NUMERICS.md', 'bench.md']) {
      const text = installed(name);
      expect(text).not.toMatch(/from '\./);
      for (const [, file = ''] of text.matchAll(/\]\(([\w-]+\.md)(?:#[\w-]*)?\)/g)) {
        expect(installed(file)).not.toBe('');
      }
    }
    expect(installed('LICENSE')).toContain('MIT');
  });
});
