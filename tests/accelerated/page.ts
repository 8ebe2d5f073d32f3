/* A page that has the math module in a bundle, and its worker: `window.told` is what both found. */

const WORKER = "import { told } from './program.mjs'; postMessage(told());";
const PAGE = `<!doctype html><title>accelerated</title><script type="module" src="page.mjs">
</script>`;
const SCRIPT = `import { told } from './program.mjs';
const inWorker = new Promise((resolve) => {
  new Worker('worker.mjs', { type: 'module' }).onmessage = ({ data }) => resolve(data);
});
window.told = inWorker.then((data) => [told(), data]);`;

/** The page's files by name; `program` is the bundle. */
export const filesOf = (program: string): Readonly<Record<string, string>> => ({
  'index.html': PAGE,
  'page.mjs': SCRIPT,
  'worker.mjs': WORKER,
  'program.mjs': program,
});

export const typeOf = (name: string): string =>
  name.endsWith('html') ? 'text/html' : 'text/javascript';

/** A content security policy by which WebAssembly may be compiled. */
export const ALLOWED = "script-src 'self' 'wasm-unsafe-eval'";
