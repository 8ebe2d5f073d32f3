import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { bundle } from '../accelerated/bundle.ts';
import { ALLOWED, filesOf, typeOf } from '../accelerated/page.ts';
import type { Told } from '../accelerated/program.ts';
import type { Seen } from './tour.ts';
import type { Tourist } from './webdriver.ts';

/** What `accelerate()` tells a page and its worker, in any browser. */
export async function accelerated(browser: Tourist): Promise<Seen> {
  const files = filesOf(await bundle());
  const server = createServer((request, response) => {
    const name = (request.url ?? '/').slice(1) || 'index.html';
    response.setHeader('Content-Type', typeOf(name));
    response.setHeader('Content-Security-Policy', ALLOWED);
    response.end(files[name] ?? '');
  });
  await new Promise<void>((resolve) => {
    server.listen(0, '127.0.0.1', resolve);
  });
  try {
    const { port } = server.address() as AddressInfo;
    await browser.goto(`http://127.0.0.1:${port}/`);
    const told = await browser.run(() => (window as unknown as { told: Promise<Told[]> }).told);
    // WebKit's driver sorts the keys.
    const lines = told.map((one) => JSON.stringify(Object.entries(one).sort()));
    return { 'accelerate() in a page and its worker': lines.join('\n') };
  } finally {
    server.close();
  }
}
