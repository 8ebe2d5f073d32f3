import { html, type TemplateResult } from 'lit';

/*
 * Code that is loaded on demand. Loading may fail: without a network, or after a newer version of
 * the site has replaced the files.
 */

const failedStyles = new Set<HTMLLinkElement>();

/** Records style sheets that fail to load. To be called once. */
export function watchStyles(root: Document): void {
  const failed = ({ target }: Event): void => {
    if (target instanceof HTMLLinkElement && target.rel === 'stylesheet') failedStyles.add(target);
  };
  // Error events of elements do not bubble, so they are caught in the capture phase.
  root.addEventListener('error', failed, true);
}

/** Loads code; after a failure it loads again what failed, also style sheets. */
export async function lazy<T>(load: () => Promise<T>): Promise<T> {
  await Promise.all([...failedStyles].map(fetchedAgain));
  return load();
}

/** Loads a style sheet again; the bundler's loader takes a failed <link> for loaded. */
function fetchedAgain(failed: HTMLLinkElement): Promise<void> {
  failedStyles.delete(failed);
  const again = failed.cloneNode() as HTMLLinkElement;
  return new Promise((resolve, reject) => {
    again.addEventListener('load', () => resolve());
    again.addEventListener('error', () => reject(new Error(`${again.href} did not come`)));
    failed.replaceWith(again);
  });
}

/** A message with buttons to try again and to reload. `what`: 'This page could not be loaded.' */
export function notLoaded(what: string, again: () => void): TemplateResult {
  return html`<div class="not-loaded" data-say="problem"><p>${what}</p>
    <button type="button" @click=${again}>Try again</button>
    <button type="button"
      title="After a new version was put online, only this helps; the link keeps what is shown"
        @click=${() => location.reload()}>Reload Graze</button>
  </div>`;
}
