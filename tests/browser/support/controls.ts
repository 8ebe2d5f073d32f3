import type { Locator, Page } from '@playwright/test';
import { hashOf, settle } from './page.ts';
import { expect } from './test.ts';

/** The box for "E.x" or "r". */
export function box(page: Page, name: string): Locator {
  return page.locator(`input.number[data-symbol="${name}"]`);
}

export function slider(page: Page, name: string): Locator {
  return page.locator(`input[type="range"][data-symbol="${name}"]`);
}

export function resetOf(page: Page, symbol: string): Locator {
  return page.getByRole('button', { name: `Reset ${symbol}`, exact: true });
}

export async function typeInto(page: Page, name: string, text: string): Promise<void> {
  await box(page, name).fill(text);
  await box(page, name).press('Enter');
  await settle(page);
}

export async function press(page: Page, target: Locator, key: string): Promise<void> {
  await target.press(key);
  await settle(page);
}

/** What a paste by keyboard or menu sends to the box. */
export async function paste(page: Page, name: string, text: string): Promise<void> {
  await box(page, name).focus();
  await box(page, name).evaluate((input, pasted) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', pasted);
    const event = new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true });
    input.dispatchEvent(event);
  }, text);
  await settle(page);
}

export async function pickShape(page: Page, title: string): Promise<void> {
  await page.getByRole('group', { name: 'Shape' }).getByRole('button', { name: title }).click();
  await settle(page);
}

/**
 * The link is written a moment after the state: its keys and values once they are as they should
 * be.
 */
export async function expectInLink(page: Page, wanted: Readonly<Record<string, string | null>>) {
  await expect(async () => {
    const given = new URLSearchParams((await hashOf(page)).split('?')[1]);
    const seen = Object.fromEntries(Object.keys(wanted).map((key) => [key, given.get(key)]));
    expect(seen).toEqual(wanted);
  }).toPass({ timeout: 10_000, intervals: [50] });
}
