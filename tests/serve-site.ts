import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';

const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.woff2': 'font/woff2',
  '.txt': 'text/plain',
};

/** Sandboxed frames and the element, which ask as strangers, need it. */
export const SHARED = { 'Access-Control-Allow-Origin': '*' };
/** What the dev server sends, too: a finer timer, and a process for the page alone. */
export const ISOLATED = {
  ...SHARED,
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
  'Cross-Origin-Resource-Policy': 'cross-origin',
};
/** The names of assets have a hash of what is in them. */
const FOR_EVER = { 'Cache-Control': 'max-age=31536000, immutable' };

interface Hosting {
  /** Where on the host the site lies: '/', or a folder as '/x/y/'. */
  readonly folder: string;
  /** A plain host sends none. */
  readonly headers: Readonly<Record<string, string>>;
  /** 0 for any free one. */
  readonly port?: number;
  readonly site?: string;
}

interface Served {
  readonly url: string;
  readonly close: () => void;
}

/** Serves what was built, from memory. */
export async function serveBuilt(hosting: Hosting): Promise<Served> {
  const { folder, headers, port = 0, site = 'dist/site' } = hosting;
  const files = new Map<string, Buffer>();
  const fileAt = (path: string): Buffer | null => {
    const known = files.get(path);
    if (known) return known;
    if (!path.startsWith(folder)) return null;
    try {
      const name = path === folder ? 'index.html' : path.slice(folder.length);
      const read = readFileSync(join(site, name));
      files.set(path, read);
      return read;
    } catch {
      return null;
    }
  };
  const server = createServer((request, response) => {
    const path = (request.url ?? '/').split('?')[0] ?? '/';
    const file = fileAt(path);
    const type = TYPES[extname(path) || '.html'] ?? 'application/octet-stream';
    const kept = path.includes('/assets/') ? FOR_EVER : {};
    if (file) response.writeHead(200, { 'Content-Type': type, ...headers, ...kept });
    else response.writeHead(404, headers);
    response.end(file);
  });
  await new Promise<void>((resolve, reject) => {
    server.once('error', reject).listen(port, '127.0.0.1', resolve);
  });
  const { port: own } = server.address() as { port: number };
  const close = (): void => {
    server.close();
    server.closeAllConnections();
  };
  return { url: `http://127.0.0.1:${own}${folder}`, close };
}

/** Serves the site on a free port; built now, unless whoever started this has built it. */
export async function serveSite(
  hosting: Hosting = { folder: '/', headers: ISOLATED },
): Promise<Served> {
  if (!process.env.SITE_IS_BUILT) {
    const { build } = await import('vite');
    await build({ logLevel: 'warn' });
  }
  return serveBuilt(hosting);
}
