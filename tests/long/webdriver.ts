import { type ChildProcess, spawn } from 'node:child_process';
import { createServer } from 'node:net';

/** A browser that is led over the site, by whatever protocol it speaks. */
export interface Tourist {
  goto(url: string): Promise<void>;
  /** Runs a function in the page; it may use nothing but what it is given. */
  run<A, R>(act: (given: A) => R | Promise<R>, given?: A): Promise<Awaited<R>>;
  close(): Promise<void>;
}

/* WebKitGTK's driver, spoken to in W3C WebDriver. */

const START_MS = 20_000;
const SCRIPT_MS = 300_000;

export async function webkitGtk(driver: string, browser: string): Promise<Tourist> {
  const port = await freePort();
  const child = spawn('xvfb-run', ['-a', driver, `--port=${port}`], {
    stdio: 'ignore',
    detached: true,
  });
  const url = `http://127.0.0.1:${port}`;
  try {
    await untilReady(url);
    const options = { binary: browser, args: ['--automation'] };
    const opened = await ask(`${url}/session`, {
      capabilities: { alwaysMatch: { 'webkitgtk:browserOptions': options } },
    });
    const session = `${url}/session/${(opened as { sessionId: string }).sessionId}`;
    await ask(`${session}/timeouts`, { script: SCRIPT_MS, pageLoad: SCRIPT_MS });
    return tourist(session, child);
  } catch (error) {
    end(child);
    throw error;
  }
}

function tourist(session: string, child: ChildProcess): Tourist {
  return {
    goto: async (url) => void (await ask(`${session}/url`, { url })),
    async run(act, given) {
      const script = `const done = arguments[1];
        Promise.resolve((${act.toString()})(arguments[0])).then(
          (value) => done({ value }), (error) => done({ error: String(error) }));`;
      const args = [given ?? null];
      const told = await ask(`${session}/execute/async`, { script, args });
      const { value, error } = told as { value?: unknown; error?: string };
      if (error !== undefined) throw new Error(error);
      return value as never;
    },
    async close() {
      await fetch(session, { method: 'DELETE' }).catch(() => null);
      end(child);
    },
  };
}

async function ask(url: string, body: unknown): Promise<unknown> {
  const response = await fetch(url, { method: 'POST', body: JSON.stringify(body) });
  const { value } = (await response.json()) as { value: unknown };
  if (response.ok) return value;
  throw new Error(String((value as { message?: string } | null)?.message ?? response.status));
}

async function untilReady(url: string): Promise<void> {
  const until = Date.now() + START_MS;
  while (Date.now() < until) {
    if ((await fetch(`${url}/status`).catch(() => null))?.ok) return;
    await new Promise((done) => setTimeout(done, 200));
  }
  throw new Error('the driver did not start');
}

function end({ pid }: ChildProcess): void {
  // The group that was started here: xvfb-run, its server, the driver, the browser.
  if (pid !== undefined) process.kill(-pid);
}

function freePort(): Promise<number> {
  return new Promise((done) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address() as { port: number };
      server.close(() => done(port));
    });
  });
}
