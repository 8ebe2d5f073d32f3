import type { Locator, Page } from '@playwright/test';
import { expect } from './test.ts';

export const report = (page: Page): Locator => page.locator('.program-report');
export const editor = (page: Page): Locator => page.getByRole('textbox', { name: /intersect/ });

/** Types a program, runs it, and waits until the run has come to its end. */
export async function runProgram(page: Page, source: string): Promise<void> {
  await editor(page).fill(source);
  const before = Number(await report(page).getAttribute('data-finished'));
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  await expect(report(page)).toHaveAttribute('data-finished', String(before + 1), {
    timeout: 30_000,
  });
}

/** Everything that the report says, in one line. */
export const told = async (page: Page): Promise<string> =>
  (await report(page).innerText()).replace(/\s+/g, ' ');

export async function openCheck(page: Page, settings: string): Promise<void> {
  await page.goto(`./#/check${settings && `?${settings}`}`);
  await page.locator('.check h2').filter({ visible: true }).first().waitFor();
}
