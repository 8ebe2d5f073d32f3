import { POINT, GLSL as SYNTAX } from '../../math/formula.ts';
import type { ExploreModel } from '../derive.ts';
import type { Export } from './define.ts';
import { body, inBraces, type Language, vectorCode } from './language.ts';
import { type Constant, partsOf } from './parts.ts';
import type { Test } from './program.ts';

/** A WebGL2 fragment shader that compiles as it stands. */
export const glsl: Export = {
  id: 'glsl',
  title: 'the ray as GLSL',
  extension: 'frag',
  mime: 'text/x-glsl',
  text: rayGlsl,
};

/** The class as the shader returns it: the index in this list. */
export const GLSL_CASES = ['undecided', 'none', 'one', 'tangent', 'two', 'contained'] as const;

const LANGUAGE: Language = {
  syntax: SYNTAX,
  comment: (text) => `// ${text}`,
  put: (name, value) => `float ${name} = ${value};`,
  vector: (parts) => `vec3(${parts.join(', ')})`,
  putVector: (name, value) => `vec3 ${name} = ${value};`,
  test: testCode,
  when: (test, then) => inBraces(test, then, '  '),
  answer: (verdict, ts) => {
    const [first = '0.0', last = first] = ts;
    return `return Answer(${verdict.toUpperCase()}, ${ts.length}, ${first}, ${last});`;
  },
  indent: '  ',
};

export function rayGlsl(model: ExploreModel): string {
  const { program, shape, E, d, ends, about, names } = partsOf(model);
  const own = names(SYNTAX.component);
  const signature = 'vec3 E, vec3 d';
  return `${[
    '#version 300 es',
    ...about.map(LANGUAGE.comment),
    ...HEAD,
    ...shape.map(constant),
    ...(ends?.heights ?? []).map(constant),
    '',
    '// The case, and t of every point of the whole line, ascending.',
    `Answer intersect(${signature}) {`,
    ...body(program, LANGUAGE, own),
    '}',
    '',
    `vec3 pointAt(${signature}, float t) {`,
    `  return ${vectorCode(POINT, LANGUAGE, own)};`,
    '}',
    '',
    "// The course's normal at X: not normalised, zero at a singular point.",
    'vec3 normalAt(vec3 X) {',
    `  return ${vectorCode(program.normal, LANGUAGE, own)};`,
    '}',
    '',
    ...[
      { name: 'E', value: E, title: 'eye' },
      { name: 'd', value: d, title: 'direction' },
    ].map(constant),
    ...(ends ? endsCode(ends.caps, ends.f(SYNTAX)) : []),
    ...(ends ? MAIN.map((line) => line.replace('= intersect(E, d)', '= left()')) : MAIN),
  ].join('\n')}\n`;
}

const HEAD =
  `// A shader has floats of 32 bits: far from the origin, or close to a tangent, it may see
// another case.
precision highp float;

${GLSL_CASES.map((name, i) => `const int ${name.toUpperCase()} = ${i};`).join('\n')}

// The case, how many t's there are, the first and the last.
struct Answer { int kind; int count; float t1; float t2; };

bool lost(float x) { return isnan(x) || isinf(x); }
`.split('\n');

/** With ends the shader returns the hits that remain: their number, the first and the last. */
const endsCode = (caps: boolean, f: string): string[] =>
  `
void keep(float t, inout Answer kept) {
  kept.t1 = kept.count == 0 ? t : min(kept.t1, t);
  kept.t2 = kept.count == 0 ? t : max(kept.t2, t);
  kept.count++;
}

bool isThere(float t) {
  float y = pointAt(E, d, t).y;
  return !(y < low) && !(y > high);
}
${
  caps
    ? `
void through(float y, Answer found, inout Answer kept) {
  if (d.y == 0.0) return;
  float t = (y - E.y) / d.y;
  vec3 X = vec3(E.x + t * d.x, y, E.z + t * d.z);
  float f = ${f};
  // On the rim the root there counts.
  if (found.kind == CONTAINED ? !(f > 0.0) : f < 0.0) keep(t, kept);
}
`
    : ''
}
// The case of the whole line; how many hits are left between the ends, the first and the last.
Answer left() {
  Answer found = intersect(E, d);
  Answer kept = Answer(found.kind, 0, 0.0, 0.0);
  if (found.count > 0 && isThere(found.t1)) keep(found.t1, kept);
  if (found.count > 1 && isThere(found.t2)) keep(found.t2, kept);
${
  caps
    ? `  through(low, found, kept);
  through(high, found, kept);
`
    : ''
}  return kept;
}`.split('\n');

const MAIN = `
out vec4 result;

void main() {
  Answer found = intersect(E, d);
  result = vec4(float(found.kind), float(found.count), found.t1, found.t2);
}`.split('\n');

function constant({ name, value, title }: Constant): string {
  return typeof value === 'number'
    ? `const float ${name} = ${SYNTAX.number(value)}; // ${title}`
    : `const vec3 ${name} = vec3(${value.map(SYNTAX.number).join(', ')}); // ${title}`;
}

function testCode(test: Test): string {
  switch (test.is) {
    case 'zero':
      return `${test.name} == 0.0`;
    case 'negative':
      return `${test.name} < 0.0`;
    case 'greater':
      return `${test.name} > ${test.than}`;
    case 'lost':
      return test.names.map((name) => `lost(${name})`).join(' || ');
    case 'positive':
      return test.names.map((name) => `${name} > 0.0 && !lost(${name})`).join(' || ');
  }
}
