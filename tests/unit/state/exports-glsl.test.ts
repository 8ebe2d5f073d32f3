import { describe, expect, test } from 'vitest';
import { GLSL_CASES, rayGlsl } from '../../../src/state/exports/glsl.ts';
import {
  EXPORT_CASES,
  type ExportCase,
  HARD_CASES,
  modelOf,
  textbookAnswer,
} from './exports-cases.ts';

/*
 * Here the shader is read as a person would read it, put into JavaScript word by word, and run in
 * doubles. That a compiler takes it, and what a GPU makes of it in 32 bits, is for the browser: see
 * EXPORT_CASES.
 */

type Vec = { x: number; y: number; z: number };

interface Shader {
  readonly result: readonly [kind: number, count: number, t1: number, t2: number];
  point(t: number): Vec;
  normal(at: Vec): Vec;
}

const PRELUDE = `
const vec3 = (x, y, z) => ({ x, y, z });
const vec4 = (...parts) => parts;
const float = (x) => x;
const { min, max, sqrt } = Math;
const isnan = Number.isNaN;
const isinf = (x) => Math.abs(x) === Infinity;
const minus = (a, b) => vec3(a.x - b.x, a.y - b.y, a.z - b.z);
const dot = (a, b) => a.x * b.x + a.y * b.y + a.z * b.z;
const length = (a) => sqrt(dot(a, a));
`;

function run(glsl: string): Shader {
  const vectors = new Set([...glsl.matchAll(/\bvec3 (\w+)\b/g)].map(([, name]) => name));
  const js = withoutComments(glsl)
    .replace(/^(#version|precision).*$/gm, '')
    .replace(
      /struct (\w+) \{([^}]*)\};/,
      (_, name, fields: string) =>
        `const ${name} = (${fields.match(/\w+(?=;)/g)}) => ({ ${fields.match(/\w+(?=;)/g)} });`,
    )
    .replace(/\bout vec4 /, 'let ')
    .replace(/^(?:bool|vec3|void|[A-Z]\w+) (\w+)\(([^)]*)\) \{/gm, (_, name, params: string) => {
      return `function ${name}(${params.replace(/\b(inout|vec3|float|Answer) /g, '')}) {`;
    })
    .replace(/\b(?:const )?(?:int|float|vec3|Answer) (\w+) =/g, 'const $1 =')
    .replace(/\b(\w+) - (\w+)\b/g, (text, a, b) =>
      vectors.has(a) && vectors.has(b) ? `minus(${a}, ${b})` : text,
    );
  const back = '{ result, point: (t) => pointAt(E, d, t), normal: normalAt }';
  return new Function(`${PRELUDE}${js}\nmain();\nreturn ${back};`)();
}

const withoutComments = (glsl: string): string => glsl.replace(/\/\/.*$/gm, '');
const asArray = ({ x, y, z }: Vec): number[] => [x, y, z];

/** With ends it tells how many hits are left, the first and the last. */
function checkEnds(c: ExportCase): void {
  const [kind, count, ...ts] = run(rayGlsl(modelOf(c))).result;
  const { class: verdict, hits } = textbookAnswer(c);
  const left = hits.filter(({ fate }) => fate !== 'cut').map(({ t }) => t);
  expect([GLSL_CASES[kind], count], c.name).toEqual([verdict, left.length]);
  expect(ts.slice(0, count), c.name).toEqual([left[0], left.at(-1)].slice(0, count));
}

function checkRun(c: ExportCase): void {
  if (c.ends) {
    checkEnds(c);
    return;
  }
  const { result, point, normal } = run(rayGlsl(modelOf(c)));
  const [kind, count, ...ts] = result;
  const hits = ts.slice(0, count).map((t) => {
    const at = point(t);
    const n = asArray(normal(at));
    const singular = n.every((x) => x === 0);
    return { t, point: asArray(at), normal: singular ? [0, 0, 0] : n, singular };
  });
  // A point at infinity may have a normal that is no number. The other programs tell; the shader
  // leaves it to its caller.
  const lost = hits.some((h) => [...h.point, ...h.normal].some(Number.isNaN));
  const found = lost ? { class: 'undecided', hits: [] } : { class: GLSL_CASES[kind], hits };
  expect(found, c.name).toEqual(textbookAnswer(c));
}

describe('read as JavaScript, in doubles, it finds what the textbook method finds', () => {
  test.each(EXPORT_CASES)('$name', checkRun);

  test(`and on ${HARD_CASES.length} hard rays`, { timeout: 60_000 }, () => {
    for (const c of HARD_CASES) checkRun(c);
  });
});

const KEYWORDS =
  'const inout out struct return if void bool int float vec3 vec4 precision highp'.split(' ');
const BUILT_IN = 'min max sqrt dot length isnan isinf x y z'.split(' ');
/**
 * Of GLSL ES 3.00, section 3.8, those that a formula's symbol or a parameter's name could come
 * near.
 */
const RESERVED = (
  'active asm attribute cast centroid class coherent common enum extern external filter ' +
  'fixed flat goto half inline inout input interface invariant layout long namespace ' +
  'noinline output partition patch public readonly resource sample sampler shared short ' +
  'sizeof smooth static superp switch template this typedef uniform union unsigned using ' +
  'varying volatile writeonly'
).split(' ');

describe('as text', () => {
  test.each(EXPORT_CASES)('$name: $shape.kind', (c) => {
    const glsl = rayGlsl(modelOf(c));
    expect(glsl.startsWith('#version 300 es\n')).toBe(true);
    expect(glsl).toContain('\nprecision highp float;\n');
    const code = withoutComments(glsl).replace(/^#version.*$/m, '');
    // Some drivers want ASCII even in comments.
    expect(glsl).toMatch(/^[\n -~]*$/);
    expect(code.match(/\{/g)?.length).toBe(code.match(/\}/g)?.length);
    for (const line of code.split('\n').map((l) => l.trim())) {
      if (line) expect(line).toMatch(/[;{}]$/);
    }
    const declared = [
      ...code.matchAll(/\b(?:bool|int|float|vec3|vec4|void|Answer|struct) (\w+)/g),
    ].map(([, name = '']) => name);
    for (const name of declared) expect([...RESERVED, ...KEYWORDS]).not.toContain(name);
    const words = code.replace(/(?<![\w.])\d[\d.]*(e[+-]?\d+)?/g, '').match(/[A-Za-z_]\w*/g) ?? [];
    const known = new Set([...declared, ...KEYWORDS, ...BUILT_IN]);
    expect([...new Set(words)].filter((word) => !known.has(word))).toEqual([]);
    // No whole number where a float is needed: only the cases and the count are of type int.
    const floats = code
      .replace(/const int .*$/gm, '')
      .replace(/count (?:>|==) \d/g, '')
      .replace(/(Answer\((?:[A-Z]+|found\.kind)), \d/g, '$1');
    expect(floats).not.toMatch(/(?<![\w.+-])\d+(?![\w.])/);
  });
});
