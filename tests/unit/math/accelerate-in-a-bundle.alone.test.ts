import { execFile } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { expect, test } from 'vitest';
import { bundle } from '../../accelerated/bundle.ts';

/* Plain Node, given one file; in Chromium: tests/browser/accelerate.spec.ts. */

const run = promisify(execFile);

const MAIN = "import { told } from './program.mjs'; console.log(JSON.stringify(told()));";
const WORKER =
  "import { parentPort } from 'node:worker_threads';\
  import { told } from './program.mjs'; parentPort.postMessage(told());";
const STARTS =
  "import { Worker } from 'node:worker_threads';\
  const worker = new Worker(new URL('worker.mjs', import.meta.url));\
  worker.on('message', (told) => console.log(JSON.stringify(told)));";

test('a bundle is accelerated in Node and in its workers, and says why it is not', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'accelerated-'));
  try {
    const files = { program: await bundle(), main: MAIN, worker: WORKER, starts: STARTS };
    for (const [name, text] of Object.entries(files)) {
      writeFileSync(join(folder, `${name}.mjs`), text);
    }
    const tell = async (file: string, ...options: string[]): Promise<unknown> =>
      JSON.parse((await run(process.execPath, [...options, join(folder, file)])).stdout);
    const fast = { isFast: true, why: null, isSame: true, isFound: true, isInMemory: true };
    expect(await tell('main.mjs')).toEqual(fast);
    expect(await tell('starts.mjs')).toEqual(fast);
    expect(await tell('main.mjs', '--no-expose-wasm')).toEqual({
      ...{ isFast: false, why: 'This engine has no WebAssembly.' },
      ...{ isSame: true, isFound: true, isInMemory: false },
    });
  } finally {
    rmSync(folder, { recursive: true });
  }
});
