import { type CodeSyntax, type Expr, type Names, printCode } from '../../math/formula.ts';
import { definitionOf } from '../../math/shapes.ts';
import { shortest } from '../../text/format.ts';
import { type Course, courseOf } from '../course.ts';
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

/** The statements that set the ray and the shape. */
function given({ posed: { draft } }: Part): string[] {
  const numbers = draft.shape as unknown as Readonly<Record<string, Answer>>;
  const own = definitionOf(draft.shape).params.flatMap(({ symbol, key, type }) => {
    const value = numbers[key];
    if (type === 'vector' && typeof value === 'object') return [`v${symbol}: ${list(value)};`];
    return typeof value === 'number' ? [`s${symbol}: ${maximaNumber(value)};`] : [];
  });
  const { origin, direction } = draft.ray;
  return [`vE: ${list(origin)};`, `vd: ${list(direction)};`, ...own];
}

/** The fields that follow from A, B and C, which STACK computes. */
const FIELDS = ['A', 'B', 'C', 'D', 't1', 't2'];

/** Statements for A, B, C, D and both roots of these formulas, and the answer's name. */
function lines(course: Course, end: string, field: string): string[] {
  if (course.family === 'flat') return [];
  const { A, B, C, D, roots, rules } = course;
  const coefficients = [A, B, C].map((tree, i) => `q${'ABC'[i]}${end}: ${maxima(tree, end)};`);
  const [low, high] = [maxima(roots, end, -1), maxima(roots, end)];
  const sorted = `sort([${low}, ${high}])`;
  const pair = rules.order === 'ascending' ? sorted : `reverse(${sorted})`;
  const needed = FIELDS.indexOf(field);
  return [
    ...coefficients,
    ...(needed >= 3 ? [`qD${end}: ${maxima(D, end)};`] : []),
    ...(needed >= 4 ? [`r${end}: ${pair};`] : []),
  ];
}

const answerName = (field: string, end: string): string =>
  field === 't1' ? `r${end}[1]` : field === 't2' ? `r${end}[2]` : `q${field}${end}`;

/** Whether STACK can compute a part's answer and those of its mistakes: roots where A ≠ 0. */
export const isForStack = ({ field, posed: { draft, exercise }, answer }: Part): boolean => {
  const course = courseOf(draft.shape);
  if (course.family === 'flat' || exercise.asksForParam || typeof answer !== 'number') return false;
  const root = FIELDS.indexOf(field) >= 4;
  return FIELDS.includes(field) && (!root || work(course, draft).case === 'two');
};

interface Node {
  readonly answer: string;
  readonly score: 0 | 1;
  readonly says: string;
}

/** The statements of a part, and the answers of the nodes. */
export function stackFormulas(part: Part): { readonly variables: string; readonly nodes: Node[] } {
  const course = courseOf(part.posed.draft.shape);
  const known = part.wrong.flatMap(({ id, says }, i) => {
    const edited = findMisconception(id)?.edit(course);
    return edited ? [{ edited, says, end: `m${i + 1}` }] : [];
  });
  const statements = [
    ...given(part),
    ...lines(course, 'r', part.field),
    ...known.flatMap(({ edited, end }) => lines(edited, end, part.field)),
    `ta: ${answerName(part.field, 'r')};`,
  ];
  return {
    variables: statements.join('\n'),
    nodes: [
      { answer: 'ta', score: 1, says: '' },
      ...known.map(({ says, end }) => ({
        ...{ answer: answerName(part.field, end), score: 0 as const, says },
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
