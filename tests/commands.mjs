// The README's other commands, each run once and briefly: what it promises has to start, do its
// work and end well. They use the site that has been built for the browser tests.
import { spawn } from 'node:child_process';
import { createServer } from 'node:net';

const BRIEF = [
  ['fuzz', '--rays', '3000', '--seed', '1'],
  ['fuzz:page', '--actions', '10', '--seed', '7'],
  ['shots', 'cone-tangent'],
  ['cases', '--family', 'vertex', '--count', '3', '--out', 'test-results/cases.json'],
  ['bench', 'page', '--scenes', 'plain', '--seconds', '1.5'],
  ['bench', 'ladder', '--families', 'typical', '--rounds', '1', '--rays', '4096'],
];
const PATIENCE_MS = 60_000;

export const freePort = () =>
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

/** Runs a script of package.json; its words are shown if it fails. */
function ends(script, args) {
  return new Promise((done) => {
    const child = spawn('npm', ['run', script, '--', ...args], {
      stdio: ['ignore', 'pipe', 'pipe'],
      env: { ...process.env, SITE_IS_BUILT: '1' },
    });
    const words = [];
    for (const stream of [child.stdout, child.stderr]) stream.on('data', (x) => words.push(x));
    child.on('close', (status) => {
      if (status !== 0) process.stderr.write(Buffer.concat(words));
      done(status === 0);
    });
  });
}

/** [passed, failed] */
export async function commands() {
  let failed = 0;
  const judge = (name, ok) => {
    console.log(`[npm ${name}: ${ok ? 'as the README says' : 'FAILED'}]`);
    if (!ok) failed++;
  };
  const waiting = [...BRIEF];
  const inTurn = async () => {
    for (let next = waiting.shift(); next; next = waiting.shift()) {
      const [script, ...args] = next;
      judge(`run ${script}`, await ends(script, args));
    }
  };
  const served = async () => {
    judge('start', await serves('start', /src\/main\.ts/));
    judge('run preview', await serves('preview', /assets\/[\w-]+\.js/));
  };
  await Promise.all([served().then(inTurn), inTurn()]);
  return [BRIEF.length + 2 - failed, failed];
}
