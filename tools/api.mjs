// `npm run api`: pages of what graze-math exports, by its doors, from the docstrings, in dist/api or
// in the folder that is given. TypeDoc has a TypeScript of its own in this folder; it reads the
// declarations of the built package. The examples are run by tests/unit/docs/docstrings.test.ts.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { built, here, installed, root } from './built.mjs';

installed();
const folder = built();
const out = resolve(root, process.argv[2] ?? 'dist/api');
const about = JSON.parse(readFileSync(`${folder}/package.json`, 'utf8'));
const doors = Object.values(about.exports).flatMap(({ types }) => types ?? []);
const entryPoints = doors.map((file) => resolve(folder, file));

const compilerOptions = {
  ...{ target: 'ES2022', module: 'NodeNext', moduleResolution: 'NodeNext', strict: true },
  ...{ types: [], lib: ['ES2023', 'DOM'], skipLibCheck: true },
};
const tsconfig = `${folder}/tsconfig.api.json`;
writeFileSync(tsconfig, JSON.stringify({ compilerOptions, files: entryPoints }));
const options = `${folder}/typedoc.json`;
writeFileSync(
  options,
  JSON.stringify({
    ...{ entryPoints, tsconfig, out, name: `${about.name} ${about.version}` },
    ...{ readme: `${folder}/README.md`, disableSources: true, hideGenerator: true },
    // A type that only another one's field has is shown there.
    validation: { notExported: false },
    treatWarningsAsErrors: true,
  }),
);
execFileSync(process.execPath, [here('node_modules/typedoc/bin/typedoc'), '--options', options], {
  cwd: root,
  stdio: 'inherit',
});
