import { readdirSync, readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import type { Lesson, Step } from '../../../src/lesson/lesson.ts';
import { readLesson } from '../../../src/lesson/read.ts';
import { innerState } from '../../../src/lesson/step-state.ts';
import { packed } from '../../../src/state/packed-text.ts';
import { rayOf, shapeOf } from '../../../src/state/state.ts';
import { expected } from './expected.ts';
import type { Shown } from './page.ts';
import { settle } from './page.ts';
import { expect } from './test.ts';

const FOLDER = new URL('../../../src/lesson/lessons/', import.meta.url);

/** The lessons that come with Graze, by their files. */
export const LESSONS: readonly Lesson[] = readdirSync(FOLDER)
  .filter((name) => name.endsWith('.md'))
  .map((name) => readLesson(readFileSync(new URL(name, FOLDER), 'utf8'), name.slice(0, -3)).lesson);

export function lessonOf(id: string): Lesson {
  const found = LESSONS.find((lesson) => lesson.id === id);
  if (!found) throw new Error(`no lesson ${id}`);
  return found;
}

/** The link of a lesson of one's own. */
export const ownLink = (text: string, step = 1): string =>
  `#/lesson/own?file=${packed(text)}${step === 1 ? '' : `&step=${step}`}`;

/** Shows a step without loading the page again; waits until it stands there. */
export async function openStep(page: Page, hash: string, number: number): Promise<void> {
  await page.evaluate((next) => {
    location.hash = next;
    dispatchEvent(new HashChangeEvent('hashchange'));
  }, hash);
  await stepShown(page, number);
}

export async function stepShown(page: Page, number: number): Promise<void> {
  await expect(page.locator('[data-lesson-step]')).toHaveAttribute(
    'data-lesson-step',
    String(number),
  );
  await settle(page);
}

/** The live numbers of the text, by name; and what the page beside it has for them. */
export async function liveNumbers(page: Page): Promise<{ text: Shown; beside: Shown }> {
  return page.evaluate(() => {
    const text: Record<string, string> = {};
    const beside: Record<string, string> = {};
    for (const element of document.querySelectorAll('.lesson-column [data-quantity]')) {
      const name = element.getAttribute('data-quantity') ?? '';
      text[name] = element.getAttribute('data-value') ?? '';
      const [row = '', cell = ''] = name.split('.');
      const found = document.querySelector(
        `.lesson-other :is([data-method="${row}"], [data-effect="${row}"])
          [data-quantity="${cell}"]`,
      );
      if (found) beside[name] = found.getAttribute('data-value') ?? '';
    }
    return { text, beside };
  });
}

/** What the math module gives for the names of a step on Explore. */
export function computed(step: Step, names: readonly string[]): Shown {
  const state = innerState(step, {});
  const all = expected(shapeOf(state), rayOf(state), state.method);
  return Object.fromEntries(names.map((name) => [name, all[name] ?? 'not there']));
}
