import { POINT, TYPESCRIPT as SYNTAX } from '../../math/formula.ts';
import { shortest } from '../../text/format.ts';
import type { ExploreModel } from '../derive.ts';
import type { Export } from './define.ts';
import { body, inBraces, type Language, vectorCode } from './language.ts';
import { type Constant, partsOf } from './parts.ts';
import type { Test } from './program.ts';

/** A program with the ray, the shape and the course's formula, that prints its result as JSON. */
export const typescript: Export = {
  id: 'typescript',
  title: 'the ray as TypeScript',
  extension: 'ts',
  mime: 'text/typescript',
  text: rayTypeScript,
};

const LANGUAGE: Language = {
  syntax: SYNTAX,
  comment: (text) => `// ${text}`,
  put: (name, value) => `const ${name} = ${value};`,
  vector: (parts) => `[${parts.join(', ')}]`,
  putVector: (name, value) => `const ${name}: Vec3 = ${value};`,
  test: testCode,
  when: (test, then) => inBraces(test, then, '  '),
  answer: (verdict, ts) => `return { class: '${verdict}', ts: [${ts.join(', ')}] };`,
  indent: '  ',
};

export function rayTypeScript(model: ExploreModel): string {
  const { program, shape, E, d, ends, about, names } = partsOf(model);
  const own = names(SYNTAX.component);
  return `${[
    ...about.map(LANGUAGE.comment),
    '',
    'type Vec3 = readonly [number, number, number];',
    '',
    ...shape.map(constant),
    ...(ends?.heights ?? []).map(constant),
    '',
    '/** The case, and t of every point of the whole line, ascending. */',
    'function intersect(E: Vec3, d: Vec3): { class: string; ts: readonly number[] } {',
    ...body(program, LANGUAGE, own),
    '}',
    '',
    "/** The point at t, and the course's normal there: not normalised, zero at a singular " +
      'point. */',
    'function hitAt(E: Vec3, d: Vec3, t: number) {',
    `  const X: Vec3 = ${vectorCode(POINT, LANGUAGE, own)};`,
    `  const normal: Vec3 = ${vectorCode(program.normal, LANGUAGE, own)};`,
    '  const singular = normal.every((n) => n === 0);',
    '  return { t, point: X, normal: singular ? [0, 0, 0] : normal, singular };',
    '}',
    '',
    ...[
      { name: 'E', value: E, title: 'eye' },
      { name: 'd', value: d, title: 'direction' },
    ].map(constant),
    ...main(ends !== null),
    ...(ends ? endsCode(ends.caps, ends.f(SYNTAX)) : []),
  ].join('\n')}\n`;
}

const main = (hasEnds: boolean): string[] =>
  hasEnds ? MAIN.map((line) => line.replace('(answer, ', '(withEnds(answer), ')) : MAIN;

const endsCode = (caps: boolean, f: string): string[] =>
  `
type Hit = ReturnType<typeof hitAt>;

/** Each root is a hit or cut off${caps ? ', and through a disc it meets a cap' : ''}. */
function withEnds({ class: kind, hits }: { class: string; hits: Hit[] }) {
  const roots = hits.map((hit) => {
    const [, y] = hit.point;
    return { ...hit, fate: y < low || y > high ? 'cut' : 'hit' };
  });
${
  caps
    ? `  if (d[1] === 0) return { class: kind, hits: roots };
  const all: typeof roots = [];
  for (const y of d[1] > 0 ? [low, high] : [high, low]) {
    const t = (y - E[1]) / d[1];
    const X: Vec3 = [E[0] + t * d[0], y, E[2] + t * d[2]];
    const f = ${f};
    // On the rim the root there counts.
    if (kind === 'contained' ? f > 0 : !(f < 0)) continue;
    while (roots[0] && !(roots[0].t > t)) all.push(roots.shift() as (typeof roots)[0]);
    all.push({ t, point: X, normal: [0, y === low ? -1 : 1, 0], singular: false, fate: 'cap' });
  }
  return { class: kind, hits: [...all, ...roots] };`
    : '  return { class: kind, hits: roots };'
}
}`.split('\n');

const MAIN = `
const found = intersect(E, d);
const hits = found.ts.map((t) => hitAt(E, d, t));
const lost = hits.some(({ point, normal }) => [...point, ...normal].some(Number.isNaN));
const answer = lost ? { class: 'undecided', hits: [] } : { class: found.class, hits };
// JSON has no −0 and no infinity: they are written as text.
const exactly = (_: string, x: unknown) => {
  if (Object.is(x, -0)) return '-0';
  return typeof x === 'number' && !Number.isFinite(x) ? String(x) : x;
};
console.log(JSON.stringify(answer, exactly));`.split('\n');

function constant({ name, value, title }: Constant): string {
  return typeof value === 'number'
    ? `const ${name} = ${shortest(value)}; // ${title}`
    : `const ${name}: Vec3 = [${value.map(shortest).join(', ')}]; // ${title}`;
}

function testCode(test: Test): string {
  switch (test.is) {
    case 'zero':
      return `${test.name} === 0`;
    case 'negative':
      return `${test.name} < 0`;
    case 'greater':
      return `${test.name} > ${test.than}`;
    case 'lost':
      return test.names.map((name) => `!Number.isFinite(${name})`).join(' || ');
    case 'positive':
      return test.names
        .map((name) => (test.names.length > 1 ? `(${positive(name)})` : positive(name)))
        .join(' || ');
  }
}

const positive = (name: string): string => `${name} > 0 && Number.isFinite(${name})`;
