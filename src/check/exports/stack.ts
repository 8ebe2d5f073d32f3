import { type CodeSyntax, type Expr, type Names, printCode } from '../../math/formula.ts';
import { definitionOf } from '../../math/shapes.ts';
import { shortest } from '../../text/format.ts';
import { courseFor } from '../compose.ts';
import type { Course } from '../course.ts';
import type { Lines } from '../exercises/define.ts';
import { findMisconception } from '../misconceptions/index.ts';
import type { Answer } from '../types.ts';
import { work } from '../work.ts';
import { moodleFile } from './moodle.ts';
import type { Part } from './parts.ts';
import { htmlInXml, xmlText } from './xml.ts';

/*
 * STACK (docs.stack-assessment.org): questions in Moodle XML whose answers Maxima computes from the
 * formulas' trees, right and edited; each known mistake is a node of the response tree.
 */

/** Numbers that doubles of questions are: a few digits; negative ones in parentheses. */
const maximaNumber = (x: number): string => (x < 0 ? `(${shortest(x)})` : shortest(x));

/** Lists of Maxima begin with 1. */
const MAXIMA: CodeSyntax = {
  number: maximaNumber,
  component: (vector, axis) => `${vector}[${{ x: 1, y: 2, z: 3 }[axis]}]`,
  sqrt: (of) => `sqrt(${of})`,
  vectors: null,
};

/** Names in Maxima: e and d would do, but E, C and D are its own or the course's for two things. */
const named = (end: string): Names => ({
  scalar: (id) => (/^[ABCD]$/.test(id) ? `q${id}${end}` : `s${id.replace(/\W/g, '')}`),
  vector: (id) => `v${id}`,
});

const maxima = (expr: Expr, end: string, branch: 1 | -1 = 1): string =>
  printCode(expr, MAXIMA, named(end), { branch });

const list = (v: readonly number[]): string => `[${v.map(maximaNumber).join(', ')}]`;

/** The statements that set the ray and the shape, or the numbers of the exercise's own lines. */
function given({ posed: { draft, exercise } }: Part, { scalars }: Lines): string[] {
  const numbersOf = ([id, x]: readonly [string, number]): string => `s${id}: ${maximaNumber(x)};`;
  if (exercise.stack !== 'from the ray') return Object.entries(scalars).map(numbersOf);
  const numbers = draft.shape as unknown as Readonly<Record<string, Answer>>;
  const own = definitionOf(draft.shape).params.flatMap(({ symbol, key, type }) => {
    const value = numbers[key];
    if (type === 'vector' && typeof value === 'object') return [`v${symbol}: ${list(value)};`];
    return typeof value === 'number' ? [numbersOf([symbol, value])] : [];
  });
  const { origin, direction } = draft.ray;
  return [`vE: ${list(origin)};`, `vd: ${list(direction)};`, ...own];
}

/** The lines of these formulas that STACK computes; null where it has nothing to compute. */
function linesOf({ posed: { draft, exercise } }: Part, course: Course): Lines | null {
  if (typeof exercise.stack === 'function') return exercise.stack(course, draft);
  if (exercise.stack !== 'from the ray' || course.family === 'flat') return null;
  const { A, B, C, D, roots } = course;
  return {
    scalars: {},
    trees: Object.entries({ A, B, C, D }),
    pair: { letters: ['t1', 't2'], tree: roots },
  };
}

/** Statements up to the field's, and at its end the pair of roots if the field is one of them. */
function statements(
  { trees, pair }: Lines,
  { rules }: Course,
  end: string,
  field: string,
): string[] {
  const last = trees.findIndex(([letter]) => letter === field);
  const needed = last < 0 ? trees : trees.slice(0, last + 1);
  const each = needed.map(([letter, tree]) => `q${letter}${end}: ${maxima(tree, end)};`);
  if (last >= 0 || !pair) return each;
  const sorted = `sort([${maxima(pair.tree, end, -1)}, ${maxima(pair.tree, end)}])`;
  return [...each, `r${end}: ${rules.order === 'ascending' ? sorted : `reverse(${sorted})`};`];
}

const answerName = (field: string, { pair }: Lines, end: string): string => {
  const at = pair?.letters.indexOf(field) ?? -1;
  return at < 0 ? `q${field}${end}` : `r${end}[${at + 1}]`;
};

/** Whether STACK can compute a part's answer and those of its mistakes: roots where A ≠ 0. */
export const isForStack = (part: Part): boolean => {
  const { field, answer, posed } = part;
  const { draft, exercise } = posed;
  const course = courseFor(exercise, draft);
  const lines = linesOf(part, course);
  if (!lines || typeof answer !== 'number') return false;
  if (lines.trees.some(([letter]) => letter === field)) return true;
  const isRoot = lines.pair?.letters.includes(field) ?? false;
  return isRoot && (exercise.stack !== 'from the ray' || work(course, draft).case === 'two');
};

interface Node {
  readonly answer: string;
  readonly score: 0 | 1;
  readonly says: string;
}

/** The statements of a part, and the answers of the nodes. */
export function stackFormulas(part: Part): { readonly variables: string; readonly nodes: Node[] } {
  const { exercise, draft } = part.posed;
  const course = courseFor(exercise, draft);
  const right = linesOf(part, course);
  if (!right) return { variables: '', nodes: [] };
  const known = part.wrong.flatMap(({ id, says }, i) => {
    const edited = findMisconception(id)?.edit(course);
    const lines = edited && linesOf(part, edited);
    return edited && lines ? [{ edited, lines, says, end: `m${i + 1}` }] : [];
  });
  const all = [
    ...given(part, right),
    ...statements(right, course, 'r', part.field),
    ...known.flatMap(({ edited, lines, end }) => statements(lines, edited, end, part.field)),
    `ta: ${answerName(part.field, right, 'r')};`,
  ];
  return {
    variables: all.join('\n'),
    nodes: [
      { answer: 'ta', score: 1, says: '' },
      ...known.map(({ lines, says, end }) => ({
        ...{ answer: answerName(part.field, lines, end), score: 0 as const, says },
      })),
    ],
  };
}

const text = (tag: string, words: string): string =>
  `    <${tag} format="html"><text>${words}</text></${tag}>`;

function stackQuestion(part: Part): string {
  const { variables, nodes } = stackFormulas(part);
  const body = htmlInXml(part.prompt) + xmlText('<p>[[input:ans1]] [[validation:ans1]]</p>');
  const tree = nodes.map(({ answer, score, says }, i) => {
    const next = i + 1 < nodes.length ? i + 1 : -1;
    return [
      '      <node>',
      `        <name>${i}</name>`,
      '        <answertest>NumRelative</answertest>',
      '        <sans>ans1</sans>',
      `        <tans>${xmlText(answer)}</tans>`,
      '        <testoptions>0.0005</testoptions>',
      '        <quiet>0</quiet>',
      `        <truescoremode>=</truescoremode><truescore>${score}</truescore>`,
      '        <truepenalty></truepenalty><truenextnode>-1</truenextnode>',
      `        <trueanswernote>prt1-${i}-T</trueanswernote>`,
      '        <truefeedback format="html">',
      `          <text>${says ? htmlInXml(says) : ''}</text>`,
      '        </truefeedback>',
      '        <falsescoremode>=</falsescoremode><falsescore>0</falsescore>',
      `        <falsepenalty></falsepenalty><falsenextnode>${next}</falsenextnode>`,
      `        <falseanswernote>prt1-${i}-F</falseanswernote>`,
      '        <falsefeedback format="html"><text></text></falsefeedback>',
      '      </node>',
    ].join('\n');
  });
  return [
    '  <question type="stack">',
    `    <name><text>${xmlText(part.title)}</text></name>`,
    text('questiontext', body),
    text('generalfeedback', htmlInXml(part.solution)),
    '    <defaultgrade>1</defaultgrade>',
    '    <penalty>0.1</penalty>',
    '    <hidden>0</hidden>',
    `    <questionvariables><text>${xmlText(variables)}</text></questionvariables>`,
    text('specificfeedback', xmlText('[[feedback:prt1]]')),
    `    <questionnote><text>${xmlText(part.id)}</text></questionnote>`,
    '    <input>',
    '      <name>ans1</name><type>numerical</type><tans>ta</tans><boxsize>15</boxsize>',
    '      <forbidfloat>0</forbidfloat><mustverify>0</mustverify>',
    '    </input>',
    '    <prt>',
    '      <name>prt1</name><value>1</value><autosimplify>1</autosimplify>',
    '      <feedbackvariables><text></text></feedbackvariables>',
    ...tree,
    '    </prt>',
    '  </question>',
  ].join('\n');
}

/** The parts that STACK can compute, as Moodle XML. */
export const stackXml = (parts: readonly Part[], category: string): string =>
  moodleFile(parts.filter(isForStack).map(stackQuestion), category);
