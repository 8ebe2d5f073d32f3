import type { Page } from '@playwright/test';
import { open } from './page.ts';
import { framesDone } from './pending.ts';
import { expect } from './test.ts';

export async function openScene(page: Page, hash: string): Promise<void> {
  await open(page, hash);
  await page.locator('canvas').waitFor();
  await still(page);
}

/** Until the scene is drawn and nothing moves; how often it has been drawn. */
export async function still(page: Page): Promise<number> {
  await expect(page.locator('[data-frames]')).toHaveAttribute('data-frames', /[1-9]/);
  await framesDone(page);
  return drawn(page);
}

/** How often the scene has been drawn. */
export async function drawn(page: Page): Promise<number> {
  return Number(await page.locator('[data-frames]').getAttribute('data-frames'));
}

/** What the canvas itself shows, without what lies over it. */
export async function picture(page: Page): Promise<Buffer> {
  await still(page);
  const show = (visibility: string): Promise<void> =>
    page.evaluate((value) => {
      for (const over of document.querySelectorAll<HTMLElement>('.scene-root > :not(canvas)')) {
        over.style.visibility = value;
      }
    }, visibility);
  await show('hidden');
  const seen = await page.locator('canvas').screenshot();
  await show('');
  return seen;
}

export async function middleOf(page: Page, selector: string): Promise<[number, number]> {
  const at = await page.locator(selector).boundingBox();
  if (!at) throw new Error(`${selector} is not shown`);
  return [at.x + at.width / 2, at.y + at.height / 2];
}
