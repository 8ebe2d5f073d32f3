import { html, type TemplateResult } from 'lit';

/*
 * Code that is loaded when it is asked for. It may not arrive: the network was gone, or a newer
 * version of the site has been put in its place, whose files have other names.
 */

const failedStyles = new Set<HTMLLinkElement>();

/** Records style sheets that fail to load. To be called once. */
export function watchStyles(root: Document): void {
  const failed = ({ target }: Event): void => {
    if (target instanceof HTMLLinkElement && target.rel === 'stylesheet') failedStyles.add(target);
  };
  // Error events of elements do not bubble: they are caught on the way down.
  root.addEventListener('error', failed, true);
}

/**
 * Loads what is not there yet; asked again after a failure, it fetches what failed again, style
 * sheets included.
 */
export async function late<T>(load: () => Promise<T>): Promise<T> {
  await Promise.all([...failedStyles].map(fetchedAgain));
  return load();
}

/**
 * A link that failed stays in the document as it is, and the bundler's own loader takes it for
 * loaded.
 */
function fetchedAgain(failed: HTMLLinkElement): Promise<void> {
  failedStyles.delete(failed);
  const again = failed.cloneNode() as HTMLLinkElement;
  return new Promise((resolve, reject) => {
    again.addEventListener('load', () => resolve());
    again.addEventListener('error', () => reject(new Error(`${again.href} did not come`)));
    failed.replaceWith(again);
  });
}

/** Says what did not come, with the two ways on. `what`: 'This page could not be loaded.' */
export function notLoaded(what: string, again: () => void): TemplateResult {
  return html`<div class="not-loaded" role="alert"><p>${what}</p>
    <button type="button" @click=${again}>Try again</button>
    <button type="button"
      title="After a new version was put online, only this helps; the link keeps what is shown"
        @click=${() => location.reload()}>Reload Graze</button>
  </div>`;
}
