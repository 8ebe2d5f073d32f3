const OFFLINE = import.meta.env.MODE === 'single';
const FILE = './offline.html';

/** What only the one file has: its licences within it. */
const MARK = '<template id="third-party">';

/**
 * Graze as one file, which works without others: of a site, the file beside it; of the one file,
 * itself as it was before it ran.
 *
 * @throws RangeError with words on why it cannot be had.
 */
export async function ownFile(): Promise<string> {
  const text = OFFLINE ? itself() : await fetched();
  if (!text.includes(MARK)) throw new RangeError(`the server sends another page in its place`);
  return text;
}

async function fetched(): Promise<string> {
  let response: Response;
  try {
    response = await fetch(FILE);
  } catch {
    throw new RangeError('no connection, or the server does not answer');
  }
  if (!response.ok) throw new RangeError(`the server answers ${response.status} for offline.html`);
  return response.text();
}

/** Scripts and styles stand in the document as they came; what they made is left out. */
function itself(): string {
  const head = document.head.cloneNode(true) as HTMLHeadElement;
  for (const one of head.querySelectorAll('script:not([type="module"])')) one.remove();
  const body = document.createElement('body');
  const app = document.createElement('div');
  app.id = 'app';
  const kept = document.getElementById('third-party');
  body.append(app, ...(kept ? [kept.cloneNode(true)] : []));
  return `<!doctype html>\n<html lang="en">\n${head.outerHTML}\n${body.outerHTML}\n</html>\n`;
}
