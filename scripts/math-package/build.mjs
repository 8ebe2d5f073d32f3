// `npm run build:math`: the math module as a package in dist/math, or in the folder that is given.
// One file a module, so that a bundler leaves out what is not imported.
import { execFileSync } from 'node:child_process';
import {
  chmodSync,
  copyFileSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const root = fileURLToPath(new URL('../..', import.meta.url));
const out = resolve(process.argv[2] ?? join(root, 'dist/math'));
const at = (path) => join(root, path);

/** What others import, and the file that each door is. */
const DOORS = {
  '.': 'index',
  './batch': 'batch',
  './accelerate': 'accelerate',
  './formula': 'formula',
  './families': 'families',
};

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
execFileSync(
  process.execPath,
  [
    at('node_modules/typescript/bin/tsc'),
    ...['-p', at('scripts/math-package/tsconfig.json'), '--outDir', join(out, 'lib')],
  ],
  { stdio: 'inherit' },
);

// tsc writes .js into imports of code only.
for (const name of readdirSync(join(out, 'lib'), { recursive: true, encoding: 'utf8' })) {
  if (!name.endsWith('.d.ts')) continue;
  const path = join(out, 'lib', name);
  const text = readFileSync(path, 'utf8');
  writeFileSync(
    path,
    text.replace(/((?:from |import\()['"]\.{1,2}\/[^'"]+)\.ts(['"])/g, '$1.js$2'),
  );
}

// The command `graze-cases`, with its runners, as one file.
const COMMAND = 'bin/graze-cases.mjs';
await build({
  configFile: false,
  logLevel: 'warn',
  root,
  build: {
    ssr: 'scripts/cases/run.ts',
    outDir: out,
    emptyOutDir: false,
    minify: false,
    target: 'node20',
    rolldownOptions: { output: { entryFileNames: COMMAND, banner: '#!/usr/bin/env node' } },
  },
});
chmodSync(join(out, COMMAND), 0o755);

const { version, license, engines } = JSON.parse(readFileSync(at('package.json'), 'utf8'));
const doors = Object.entries(DOORS).map(([door, file]) => [
  door,
  { types: `./lib/math/${file}.d.ts`, default: `./lib/math/${file}.js` },
]);
const description =
  'Where a ray meets a plane, cylinder, cone, hyperboloid, sphere, paraboloid, circle or square: ' +
  'the class of exact arithmetic, roots right to the last bit.';
const about = {
  ...{ name: 'graze-math', version, description, license, engines, type: 'module' },
  keywords: ['ray', 'intersection', 'quadric', 'robust', 'exact', 'ray tracing'],
  sideEffects: false,
  bin: { 'graze-cases': COMMAND },
  exports: { ...Object.fromEntries(doors), './package.json': './package.json' },
  types: './lib/math/index.d.ts',
};
writeFileSync(join(out, 'package.json'), `${JSON.stringify(about, null, 2)}\n`);

/** A document as it stands in the package: its own names, and files beside each other. */
function documented(name) {
  const file = /\.\/src\/math\/([\w-]+)\.ts|`src\/math(?:\/([\w-]+)\.ts)?`/g;
  return readFileSync(at(`docs/${name}`), 'utf8').replace(file, (found, imported, named) => {
    if (!found.startsWith('`')) return `graze-math${doorOf(imported) ?? `/${imported}`}`;
    return `\`graze-math${named === undefined ? '' : (doorOf(named) ?? `/${named}`)}\``;
  });
}

/** '' for the main door, '/batch' for another; undefined for a file that is none. */
function doorOf(file) {
  return Object.entries(DOORS)
    .find(([, one]) => one === file)?.[0]
    .slice(1);
}

const INSTALL = ['# graze-math', '', '    npm install graze-math', ''].join('\n');
writeFileSync(
  join(out, 'README.md'),
  documented('MATH-MODULE.md').replace(/^# The math module\n/, INSTALL),
);
for (const name of ['NUMERICS.md', 'bench.md']) writeFileSync(join(out, name), documented(name));
copyFileSync(at('LICENSE'), join(out, 'LICENSE'));
