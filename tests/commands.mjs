// The README's other commands, each run once and briefly: what it promises has to start, do its
// work and end well.
import { spawn, spawnSync } from 'node:child_process';
import { createServer } from 'node:net';

const BRIEF = [
  ['fuzz', '--rays', '3000', '--seed', '1'],
  ['fuzz:page', '--actions', '30', '--seed', '7'],
  ['shots', 'cone-tangent'],
  ['bench', 'page'],
  ['bench', 'ladder', '--families', 'typical', '--rounds', '1'],
];
const PATIENCE_MS = 60_000;

const freePort = () =>
  new Promise((ok) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => ok(port));
    });
  });

/** Whether `npm run` with this script serves a page that has `program` in it, and that too. */
async function serves(script, program) {
  const port = await freePort();
  const where = ['--host', '127.0.0.1', '--port', String(port), '--strictPort'];
  const argv = ['run', script, '--', ...where];
  const server = spawn('npm', argv, {
    stdio: 'ignore',
    detached: true,
    env: { ...process.env, BROWSER: 'none' },
  });
  try {
    const until = Date.now() + PATIENCE_MS;
    while (Date.now() < until) {
      const page = await fetch(`http://127.0.0.1:${port}/`).catch(() => null);
      if (page?.ok) {
        const [path] = program.exec(await page.text()) ?? [];
        return path !== undefined && (await fetch(`http://127.0.0.1:${port}/${path}`)).ok;
      }
      await new Promise((ok) => setTimeout(ok, 200));
    }
    return false;
  } finally {
    process.kill(-server.pid);
  }
}

/** [passed, failed] */
export async function commands() {
  let failed = 0;
  const judge = (name, ok) => {
    console.log(`[npm ${name}: ${ok ? 'as the README says' : 'FAILED'}]`);
    if (!ok) failed++;
  };
  judge('start', await serves('start', /src\/main\.ts/));
  judge('run preview', await serves('preview', /assets\/[\w-]+\.js/));
  for (const [script, ...args] of BRIEF) {
    const { status, stdout, stderr } = spawnSync('npm', ['run', script, '--', ...args], {
      encoding: 'utf8',
    });
    if (status !== 0) console.error(`${stdout}\n${stderr}`);
    judge(`run ${script}`, status === 0);
  }
  return [BRIEF.length + 2 - failed, failed];
}
