import type { Lesson, Step } from './lesson.ts';

/** A lesson as its text. */
export function writeLesson({ title, about, steps }: Lesson): string {
  const front = [`title: ${title}`, ...(about ? [`about: ${about}`] : [])];
  const sources = steps.map(({ source }) => source);
  return [`---\n${front.join('\n')}\n---`, ...sources].join('\n\n').concat('\n');
}

/** A lesson with other steps. */
export const withSteps = (lesson: Lesson, sources: readonly string[]): string =>
  writeLesson({ ...lesson, steps: sources.map((source) => ({ source }) as Step) });

/** A step that begins with what a page shows now. */
export const newStep = (title: string, link: string): string =>
  `## ${title}\n\nlink: ${link}\n\nWhat to see here.`;

/** A lesson of one's own before it has any text. */
export const firstText = (link: string): string =>
  `---\ntitle: My lesson\n---\n\n${newStep('First step', link)}\n`;
