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

/** `npm start` serves the page and its program. */
async function starts() {
  const port = await freePort();
  const argv = ['start', '--', '--host', '127.0.0.1', '--port', String(port), '--strictPort'];
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
        const program = await fetch(`http://127.0.0.1:${port}/src/main.ts`);
        return (await page.text()).includes('/src/main.ts') && program.ok;
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
  judge('start', await starts());
  for (const [script, ...args] of BRIEF) {
    const { status, stdout, stderr } = spawnSync('npm', ['run', script, '--', ...args], {
      encoding: 'utf8',
    });
    if (status !== 0) console.error(`${stdout}\n${stderr}`);
    judge(`run ${script}`, status === 0);
  }
  return [BRIEF.length + 1 - failed, failed];
}
