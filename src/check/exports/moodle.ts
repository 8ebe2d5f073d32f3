import { type Part, plainNumber } from './parts.ts';
import { htmlInXml, xmlText } from './xml.ts';

/*
 * Moodle XML (docs.moodle.org, "Moodle XML format"): numerical and multiple choice questions, with
 * the remedy of each known mistake as feedback on the answer that it gives.
 */

const text = (tag: string, words: string): string =>
  `    <${tag} format="html"><text>${htmlInXml(words)}</text></${tag}>`;

function moodleHead(part: Part): string[] {
  return [
    `    <name><text>${xmlText(part.title)}</text></name>`,
    text('questiontext', part.prompt),
    text('generalfeedback', part.solution),
    '    <defaultgrade>1</defaultgrade>',
    '    <penalty>0.3333333</penalty>',
    '    <hidden>0</hidden>',
  ];
}

function answer(value: string, fraction: number, says: string, tolerance: string[]): string {
  return [
    `    <answer fraction="${fraction}" format="plain_text">`,
    `      <text>${xmlText(value)}</text>`,
    `      <feedback format="html"><text>${says ? htmlInXml(says) : ''}</text></feedback>`,
    ...tolerance.map((line) => `      ${line}`),
    '    </answer>',
  ].join('\n');
}

function numerical(part: Part): string {
  const line = (x: number): string[] => [
    `<tolerance>${plainNumber(x === part.answer ? part.tolerance : tolerance(x))}</tolerance>`,
  ];
  const tolerance = (x: number): number => 5e-4 * (x === 0 ? 1 : Math.abs(x));
  const right = part.answer as number;
  return [
    '  <question type="numerical">',
    ...moodleHead(part),
    answer(plainNumber(right), 100, '', line(right)),
    ...part.wrong.map(({ answer: other, says }) =>
      answer(plainNumber(other as number), 0, says, line(other as number)),
    ),
    '    <unitgradingtype>0</unitgradingtype>',
    '    <showunits>3</showunits>',
    '  </question>',
  ].join('\n');
}

const choice = (part: Part): string =>
  [
    '  <question type="multichoice">',
    ...moodleHead(part),
    '    <single>true</single>',
    '    <shuffleanswers>true</shuffleanswers>',
    '    <answernumbering>none</answernumbering>',
    ...part.options.map(({ id, title }) =>
      answer(
        title,
        id === part.answer ? 100 : 0,
        part.wrong.find((one) => one.answer === id)?.says ?? '',
        [],
      ),
    ),
    '  </question>',
  ].join('\n');

export const moodleFile = (questions: readonly string[], category: string): string =>
  [
    '<?xml version="1.0" encoding="UTF-8"?>',
    '<quiz>',
    '  <question type="category">',
    `    <category><text>$course$/${xmlText(category.replaceAll('/', '//'))}</text></category>`,
    '  </question>',
    ...questions,
    '</quiz>',
    '',
  ].join('\n');

/** The parts as a file for Moodle's question bank. */
export const moodleXml = (parts: readonly Part[], category: string): string =>
  moodleFile(
    parts.map((part) => (typeof part.answer === 'number' ? numerical(part) : choice(part))),
    category,
  );
