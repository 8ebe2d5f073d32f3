import type { Page } from '@playwright/test';
import { open } from './page.ts';
import { expect } from './test.ts';

export async function openScene(page: Page, hash: string): Promise<void> {
  await open(page, hash);
  await page.locator('canvas').waitFor();
  await still(page);
}

/** Until no frame has been drawn for a while. */
export async function still(page: Page): Promise<number> {
  let last = -1;
  await expect(async () => {
    const frames = Number(await page.locator('[data-frames]').getAttribute('data-frames'));
    const same = frames === last;
    last = frames;
    expect(same && frames > 0).toBe(true);
  }).toPass({ intervals: [120] });
  return last;
}

/** What the canvas itself shows, without what lies over it. */
export async function picture(page: Page): Promise<Buffer> {
  await still(page);
  await page.evaluate(() => {
    for (const over of document.querySelectorAll<HTMLElement>('.scene-root > :not(canvas)')) {
      over.style.visibility = 'hidden';
    }
  });
  return page.locator('canvas').screenshot();
}

export async function middleOf(page: Page, selector: string): Promise<[number, number]> {
  const at = await page.locator(selector).boundingBox();
  if (!at) throw new Error(`${selector} is not shown`);
  return [at.x + at.width / 2, at.y + at.height / 2];
}
