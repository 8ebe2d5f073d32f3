import { type Part, plainNumber } from './parts.ts';

/* GIFT (docs.moodle.org, "GIFT format"): Moodle, and others that read it. */

/** Text with GIFT's own characters escaped, on one line. */
const plain = (text: string): string =>
  text.replace(/[\\~=#{}:]/g, (c) => `\\${c}`).replace(/\r?\n/g, '\\n');

const feedback = (says: string): string => (says ? `#${plain(says)}` : '');

const tolerance = (x: number): number => 5e-4 * (x === 0 ? 1 : Math.abs(x));

function answers({ answer, options, wrong }: Part): string[] {
  if (typeof answer === 'number') {
    const one = (x: number, share: number, says: string): string =>
      `  =%${share}%${plainNumber(x)}:${plainNumber(tolerance(x))}${feedback(says)}`;
    return [
      one(answer, 100, ''),
      ...wrong.map(({ answer: other, says }) => one(other as number, 0, says)),
    ];
  }
  return options.map(({ id, title }) => {
    const says = wrong.find((one) => one.answer === id)?.says ?? '';
    return `  ${id === answer ? '=' : '~'}${plain(title)}${feedback(says)}`;
  });
}

/** The parts as GIFT. */
export const gift = (parts: readonly Part[]): string =>
  `${parts
    .map((part) => {
      const open = typeof part.answer === 'number' ? '{#' : '{';
      const head = `::${plain(part.title)}::[plain]${plain(part.prompt)} ${open}`;
      const general = `  ####${plain(part.solution)}`;
      return [head, ...answers(part), general, '}'].join('\n');
    })
    .join('\n\n')}\n`;
