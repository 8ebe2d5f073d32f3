import { readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { build } from 'vite';

const SITE = 'dist/site';
const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.woff2': 'font/woff2',
};

interface Hosting {
  /** Where on the host the site lies: '/', or a folder as '/x/y/'. */
  readonly folder: string;
  /** Whether the headers are sent that the dev server gives; a plain host sends none. */
  readonly isolated: boolean;
}

/** Serves the site on a free port; built now, unless whoever started this has built it. */
export async function serveSite(
  { folder, isolated }: Hosting = { folder: '/', isolated: true },
): Promise<{ url: string; close: () => void }> {
  if (!process.env.SITE_IS_BUILT) await build({ logLevel: 'warn' });
  const server = createServer((request, response) => {
    const path = (request.url ?? '/').split('?')[0] ?? '/';
    const file = join(SITE, path === folder ? 'index.html' : path.slice(folder.length));
    try {
      if (!path.startsWith(folder)) throw new RangeError(path);
      statSync(file);
      response.setHeader('Content-Type', TYPES[extname(file)] ?? 'application/octet-stream');
      if (isolated) {
        response.setHeader('Cross-Origin-Opener-Policy', 'same-origin');
        response.setHeader('Cross-Origin-Embedder-Policy', 'require-corp');
      }
      response.end(readFileSync(file));
    } catch {
      response.statusCode = 404;
      response.end();
    }
  });
  await new Promise<void>((resolve) => {
    server.listen(0, '127.0.0.1', resolve);
  });
  const { port } = server.address() as { port: number };
  return { url: `http://127.0.0.1:${port}${folder}`, close: () => server.close() };
}
