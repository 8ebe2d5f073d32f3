import { html } from 'lit';
import type { Lesson, Step } from '../../lesson/lesson.ts';
import { innerState } from '../../lesson/step-state.ts';
import type { Settings } from '../../state/state.ts';
import { createDialog } from '../../ui/dialog.ts';
import { numbersOf, type SeenPage } from '../handout/lesson-handout.ts';
import { UNFINISHED, valueOnPage } from './prose-tools.ts';
import type { ShownValue } from './prose-view.ts';

/** Longest wait in ms for one step; what it lacks then is missing on paper. */
const PATIENCE_MS = 60_000;
/** Least height of a drawing that counts, in CSS pixels: icons are smaller. */
const LEAST_HEIGHT = 60;

/**
 * Snapshots of steps on pages other than Explore, for paper. `show` shows the step of some settings
 * in `page`; null shows the state's own again.
 */
export function createPageSnapshots(page: HTMLElement, show: (settings: Settings | null) => void) {
  const seen = new Map<string, SeenPage>();
  let waiting: { readonly step: Step; readonly done: () => void } | null = null;
  let progress = '';
  const content = () => html`<p data-say>${progress}</p>`;
  const dialog = createDialog('Printing', content, undefined, () => waiting?.done());

  const isMissing = (step: Step): boolean =>
    !seen.has(step.source) && innerState(step, {}).page !== 'explore';

  /** The numbers that the page shows now; null while some are to come. */
  const valuesNow = (step: Step): Map<string, ShownValue> | null => {
    if (isBusy(page) || !isDrawn(page)) return null;
    const values = new Map<string, ShownValue>();
    for (const name of numbersOf(step)) {
      const value = valueOnPage(page, name);
      if (!value) return null;
      values.set(name, value);
    }
    return values;
  };

  return {
    seen: (step: Step): SeenPage | null => {
      const found = seen.get(step.source);
      return found ? { ...found, picture: found.picture.cloneNode(true) as Element } : null;
    },
    /** The page of this step has been drawn. */
    drawn(step: Step): void {
      const values = valuesNow(step);
      if (values) seen.set(step.source, { values, picture: pictureOf(page) });
      if (values && waiting?.step === step) waiting.done();
    },
    /** Shows what has not been shown yet, step by step. */
    async prepare(lesson: Lesson, settings: Settings): Promise<boolean> {
      const missing = lesson.steps.filter(isMissing);
      if (missing.length === 0) return true;
      let isWanted = true;
      for (const [i, step] of missing.entries()) {
        const number = lesson.steps.indexOf(step) + 1;
        progress = `Step ${number} has not been shown yet: its page is worked out for paper
          (${i + 1} of ${missing.length}). Close this to print nothing.`;
        dialog.open();
        dialog.refresh();
        await new Promise<void>((resolve) => {
          const timer = setTimeout(resolve, PATIENCE_MS);
          const done = (): void => {
            clearTimeout(timer);
            resolve();
          };
          waiting = { step, done };
          show({ ...settings, step: String(number), shown: '1' });
        });
        waiting = null;
        isWanted = dialog.isOpen;
        if (!isWanted) break;
      }
      dialog.close();
      show(null);
      return isWanted;
    },
  };
}

const isBusy = (page: HTMLElement): boolean =>
  [...page.querySelectorAll(`${UNFINISHED}, progress, [aria-busy="true"]`)].some((one) =>
    one.checkVisibility(),
  );

const isDrawn = (page: HTMLElement): boolean =>
  [...page.querySelectorAll('svg, canvas, table, form, .ladder-row')].some(
    (one) => one.checkVisibility() && one.getBoundingClientRect().height >= LEAST_HEIGHT,
  );

/** Controls, which do nothing on paper; a copied custom element would also run its code again. */
const CONTROLS =
  'button:not(.value), input, select, textarea, progress, .split, .side, .picture-bar, ' +
  'graze-number, graze-slider, .param, ' +
  '.acc-order, #picture-method, .start-row, .pixel-problem, .acc-hint';

/** A copy of the shown page, without controls and with images in place of canvases. */
function pictureOf(page: HTMLElement): Element {
  const copy = page.cloneNode(true) as HTMLElement;
  copy.className = 'lesson-other';
  const copies = copy.querySelectorAll('canvas');
  for (const [i, canvas] of page.querySelectorAll('canvas').entries()) {
    const image = document.createElement('img');
    image.alt = '';
    image.src = canvas.toDataURL();
    image.className = canvas.className;
    if (canvas.checkVisibility()) copies[i]?.replaceWith(image);
    else copies[i]?.remove();
  }
  for (const one of copy.querySelectorAll(`[data-elsewhere], ${CONTROLS}`)) one.remove();
  // Ids get a prefix: a reference to an element of the hidden page would hide the copy.
  for (const one of copy.querySelectorAll('[id], [clip-path]')) {
    if (one.id !== '') one.id = `paper-${one.id}`;
    const clip = one.getAttribute('clip-path');
    if (clip !== null) one.setAttribute('clip-path', clip.replace('url(#', 'url(#paper-'));
  }
  return copy;
}
