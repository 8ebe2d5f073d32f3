import type { Page } from '@playwright/test';
import { NO_SCENE, withoutScene } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

/*
 * All controls of a page, moved in one task, leave what they leave when each is moved after the
 * page was drawn again: no edit is made of what was drawn last.
 */

test.use({ provoked: NO_SCENE });

/**
 * Browsers refuse hundreds of addresses within seconds: the page does not write its own, so the
 * first can be opened again.
 */
async function openUnwritten(page: Page, hash: string): Promise<void> {
  if (page.url() === 'about:blank')
    await page.addInitScript(() => {
      const LINK_DELAY_MS = 150;
      const later = window.setTimeout.bind(window);
      Object.assign(window, {
        setTimeout: (run: () => void, ms?: number) => (ms === LINK_DELAY_MS ? 0 : later(run, ms)),
      });
    });
  await withoutScene(page);
  await page.goto(`./${hash}`);
  await page.locator('main :is([data-quantity], select)').first().waitFor();
}

/** In both orders: an edit that undoes the others is not seen where it is the first. */
const BOTH = [false, true] as const;

/**
 * What was lost of the edits of everything in `root`, forwards and turned round; and how many
 * there were.
 */
async function movedAtOnce(
  page: Page,
  root: string,
  orders: readonly boolean[] = BOTH,
): Promise<{ moved: number; lost: string[] }> {
  return page.evaluate(
    async ([root, orders]) => {
      const KINDS =
        ':is(graze-number, graze-slider, select, input[type=checkbox], input[type=color], ' +
        // What plays goes on by itself, frame by frame.
        'button[aria-pressed]:not(.play-number))';
      const drawn = () =>
        new Promise<void>((done) =>
          requestAnimationFrame(() => requestAnimationFrame(() => done())),
        );
      const open = async () => {
        dispatchEvent(new HashChangeEvent('hashchange'));
        await drawn();
      };
      const nameOf = (element: Element): string => {
        const name =
          (element as Element & { label?: string }).label ??
          element.getAttribute('aria-label') ??
          element.closest('label, button')?.textContent;
        return `${element.tagName} ${element.id} ${(name ?? '').trim().slice(0, 30)}`;
      };
      const controls = (): Map<string, Element> => {
        const found = new Map<string, Element>();
        for (const element of document.querySelectorAll(`:is(${root}) ${KINDS}`)) {
          const isShown = element.getClientRects().length > 0;
          if (isShown && !found.has(nameOf(element))) found.set(nameOf(element), element);
        }
        return found;
      };
      /** What stands in the controls of the whole page. */
      const values = (): string[] =>
        [...document.querySelectorAll(`main ${KINDS}`)].map((element) => {
          const { value, checked } = element as Partial<HTMLInputElement>;
          return `${nameOf(element)}: ${value} ${checked} ${element.getAttribute('aria-pressed')}`;
        });
      /** Moving a control, from where it stands now: given again later it does the same. */
      const moveOf = (element: Element): ((target: Element) => void) => {
        const put =
          (value: string, ...types: string[]) =>
          (target: Element) => {
            const input = target.matches('select, input') ? target : target.querySelector('input');
            if (!input) return;
            (input as HTMLInputElement).value = value;
            for (const type of types) input.dispatchEvent(new Event(type, { bubbles: true }));
          };
        if (element.tagName === 'GRAZE-NUMBER') {
          const { value, check } = element as Element & {
            value: number;
            check: (x: number) => string | null;
          };
          const next = [value + 0.05, value - 0.05, value + 1].find((x) => check(x) === null);
          return put(String(next), 'input', 'change');
        }
        if (element.tagName === 'GRAZE-SLIDER') {
          const { min, max } = element.querySelector('input') as HTMLInputElement;
          return put(String(Number(min) + 0.6 * (Number(max) - Number(min))), 'input');
        }
        if (element instanceof HTMLSelectElement) {
          const next = element.options[(element.selectedIndex + 1) % element.options.length];
          return put(next?.value ?? '', 'change');
        }
        if (element.matches('[type=color]')) return put('#123456', 'input');
        return (target) => (target as HTMLElement).click();
      };

      const lost: string[] = [];
      let moved = 0;
      for (const turned of orders) {
        await open();
        const all = [...controls()].map(([name, element]) => [name, moveOf(element)] as const);
        if (turned) all.reverse();
        const done: typeof all = [];
        for (const [name, move] of all) {
          const element = controls().get(name);
          // What an edit takes off the page is nothing that anybody could move after it.
          if (!element) continue;
          move(element);
          await drawn();
          done.push([name, move]);
        }
        const wanted = values();
        await open();
        const now = controls();
        for (const [name, move] of done) move(now.get(name) as Element);
        await drawn();
        const got = values();
        lost.push(...wanted.filter((line) => !got.includes(line)));
        moved += done.length;
      }
      return { moved, lost };
    },
    [root, orders] as const,
  );
}

const PLACES: readonly (readonly [hash: string, root: string])[] = [
  ['#/explore?shape=cone', '.controls, .algebra'],
  ['#/accuracy?shape=hyperboloid&hard=near-tangent', 'main'],
  ['#/check?part=own&shape=circle', '.check-left'],
  ['#/picture?scene=everything&size=16x9', '.picture-bar, .side-panel'],
];

for (const [hash, root] of PLACES) {
  test(`all edits in one task: ${hash}`, async ({ page }) => {
    await openUnwritten(page, hash);
    const { moved, lost } = await movedAtOnce(page, root);
    expect(lost).toEqual([]);
    expect(moved).toBeGreaterThan(10);
  });
}

test('all edits in one task: the forms of a scene', async ({ page }) => {
  await openUnwritten(page, '#/picture?scene=everything&size=16x9');
  await page.getByRole('tab', { name: 'Scene' }).click();
  const parts = page.locator('.part-name');
  const form = page.locator('.part-form');
  const known = new Set<string>();
  for (let i = 0; i < (await parts.count()); i++) {
    await parts.nth(i).click();
    // A form with the same fields as one before is made by the same code.
    const fields = (await form.innerText()).replace(/[−\d.]+/g, '');
    if (known.has(fields)) continue;
    known.add(fields);
    // The forms have most of their fields in common: by turns in one order and in the other.
    const orders = process.env.LONG ? BOTH : [known.size % 2 === 0];
    const { moved, lost } = await movedAtOnce(page, '.part-form', orders);
    expect(lost).toEqual([]);
    expect(moved).toBeGreaterThan(0);
  }
});
