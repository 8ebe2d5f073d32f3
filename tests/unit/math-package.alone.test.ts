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
/**
 * Bytes of the buffer in which a double's bits are looked at, of a stage's table of bounds, and of
 * what a loop hands on.
 */
const A_DOUBLE = 8;
const BOUNDS = 144;
const LOOP = 6144;

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

/** How often each function of a module runs while it is imported, by name, as V8 counts it. */
async function runAtImport(names: string): Promise<ReadonlyMap<string, number>> {
  const folder = mkdtempSync(join(project, 'import-'));
  writeFileSync(
    join(folder, 'it.mjs'),
    await bundled(`export { ${names} } from 'graze-math';`, false),
  );
  const env = { ...process.env, NODE_V8_COVERAGE: join(folder, 'counts') };
  execFileSync(process.execPath, ['it.mjs'], { cwd: folder, env });
  const [file = ''] = readdirSync(join(folder, 'counts'));
  const { result } = JSON.parse(readFileSync(join(folder, 'counts', file), 'utf8'));
  const { functions } = result.find(({ url }: { url: string }) => url.endsWith('/it.mjs'));
  const counts = new Map<string, number>();
  // The first is the module itself.
  for (const { functionName, ranges } of functions.slice(1)) {
    const [{ count }] = ranges;
    if (count > 0) counts.set(functionName, (counts.get(functionName) ?? 0) + count);
  }
  return counts;
}

/** What only the trees of shapes are made with. */
const TREES = ['signedSum', 'momentAbout', 'components', 'cross', 'vec', 'dot'];

describe('what is done when it is imported', () => {
  test('nothing at all for ulpDistance', async () => {
    expect([...(await runAtImport('ulpDistance'))]).toEqual([]);
  });

  test.each(SHAPES.map(({ kind }) => kind))('%s: its own value is made, no other', async (kind) => {
    const counts = await runAtImport(`prepareWith, ${kind}`);
    const { params } = SHAPES.find((one) => one.kind === kind) ?? { params: [] };
    const points = params.filter((one) => one.type === 'vector' && !('nonZero' in one));
    expect(counts.get('pointParam')).toBe(points.length);
    // Neither a method that nobody asked for, nor a family of rays, nor its trees.
    for (const name of ['treeMethod', 'family', ...TREES]) {
      expect([name, counts.get(name)]).toEqual([name, undefined]);
    }
  });

  test.each([
    ['/formula', A_DOUBLE],
    ['', BOUNDS],
    ['/families', BOUNDS],
    // Loops hand numbers on in arrays that the engine has to know before it compiles them.
    ['/batch', LOOP],
    ['/accelerate', LOOP],
  ])('no array but for constants, and no WebAssembly: graze-math%s', (door, most) => {
    writeFileSync(join(project, 'watch.mjs'), watching(door, most));
    expect(JSON.parse(node(['watch.mjs']))).toEqual([]);
  });
});

/** A program that imports a door, and says which things of more bytes are made by that. */
const watching = (door: string, most: number): string => `
const made = [];
for (const name of ['Float64Array', 'Float32Array', 'Int32Array', 'Uint8Array', 'ArrayBuffer']) {
  globalThis[name] = new Proxy(globalThis[name], {
    construct(target, argv, self) {
      const it = Reflect.construct(target, argv, self);
      if (it.byteLength > ${most}) made.push(name + ' of ' + it.byteLength + ' bytes');
      return it;
    },
  });
}
for (const name of ['Module', 'Instance', 'Memory']) {
  WebAssembly[name] = class { constructor() { made.push(name); } };
}
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
