import type { Page } from '@playwright/test';

interface Extent {
  readonly width: number;
  readonly height: number;
}

export async function extent(page: Page): Promise<Extent> {
  return page.evaluate(() => {
    const { scrollWidth, scrollHeight } = document.scrollingElement as Element;
    return { width: scrollWidth, height: scrollHeight };
  });
}

/** Pairs of texts that lie on each other, and texts that stick out of the window. */
export async function collisions(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    /** What is left of a box within the frames that cut it off or scroll it. */
    const seen = (element: Element, { left, top, right, bottom }: DOMRect) => {
      const box = { left, top, right, bottom };
      for (let at: Element | null = element; at; at = at.parentElement) {
        if (getComputedStyle(at).overflowX === 'visible') continue;
        const frame = at.getBoundingClientRect();
        box.left = Math.max(box.left, frame.left);
        box.right = Math.min(box.right, frame.right);
        box.top = Math.max(box.top, frame.top);
        box.bottom = Math.min(box.bottom, frame.bottom);
      }
      return box;
    };
    const selectors = [
      '.hit .value',
      '.hit .name',
      '.hit .chip',
      '.step .result',
      '.step .in-symbols',
      '.step .in-numbers',
      '.normal-value',
      '.verdict',
      '.condition > *',
      '.group > *',
      '.param .letter',
    ];
    const items = selectors.flatMap((selector) =>
      [...document.querySelectorAll(selector)].flatMap((element) => {
        const range = document.createRange();
        range.selectNodeContents(element);
        const box = seen(element, range.getBoundingClientRect());
        const text = `${selector} ${element.textContent?.replace(/\s+/g, ' ').trim().slice(0, 40)}`;
        return box.right > box.left && box.bottom > box.top ? [{ element, box, text }] : [];
      }),
    );
    const found: string[] = [];
    for (const [i, a] of items.entries()) {
      if (a.box.right > innerWidth + 1 || a.box.left < -1) found.push(`sticks out: ${a.text}`);
      for (const b of items.slice(i + 1)) {
        if (a.element.contains(b.element) || b.element.contains(a.element)) continue;
        const x = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
        const y = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
        if (x > 1 && y > 4)
          found.push(`${a.text} | ${b.text}: ${Math.round(x)} × ${Math.round(y)} px`);
      }
    }
    return found;
  });
}

/** Boxes and rows whose text is cut off at their edge. */
export async function cutOff(page: Page): Promise<string[]> {
  return page.evaluate(() =>
    [
      ...document.querySelectorAll(
        '.step .body, .value, .verdict, .chip, .condition, .meaning, .group',
      ),
    ]
      .filter((element) => {
        const { overflowX } = getComputedStyle(element);
        return element.scrollWidth > element.clientWidth + 1 && overflowX === 'hidden';
      })
      .map(
        (element) =>
          `${element.className}: ${element.textContent?.replace(/\s+/g, ' ').slice(0, 60)}`,
      ),
  );
}
