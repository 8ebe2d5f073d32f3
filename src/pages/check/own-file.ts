const OFFLINE = import.meta.env.MODE === 'single';
const FILE = './offline.html';

/** An element that only the offline file has: the licences. */
const MARK = '<template id="third-party">';

/**
 * The text of the offline file: on a site it is fetched, in the offline file it is this document
 * without what its scripts have added.
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

/** The document's scripts and styles as loaded, with an empty page. */
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
