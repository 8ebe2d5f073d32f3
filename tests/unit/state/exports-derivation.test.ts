import { spawnSync } from 'node:child_process';
import { describe, expect, test } from 'vitest';
import { float64 } from '../../../src/math/arithmetic/float64.ts';
import { evaluate } from '../../../src/math/formula/evaluate.ts';
import { isWritable } from '../../../src/math/formula/recompute.ts';
import type { ExploreModel } from '../../../src/state/derive.ts';
import { shownResult } from '../../../src/state/exact-digits.ts';
import { EXPORTS } from '../../../src/state/exports/index.ts';
import { derivationLatex } from '../../../src/state/exports/latex.ts';
import { derivationMathml } from '../../../src/state/exports/mathml.ts';
import { display } from '../../../src/text/format.ts';
import { plainPowers, subscript, superscript } from '../../../src/text/scripts.ts';
import { readLatex } from '../math/print-reader.ts';
import { asLatex, elements, parseXml, textOf } from '../math/print-xml.ts';
import { EXPORT_CASES, modelOf } from './exports-cases.ts';

/** One row of either export: left, right, and the words behind. */
interface Row {
  readonly left: string;
  readonly relation: string;
  /** What stands between the equals signs on the right. */
  readonly chain: readonly string[];
  readonly words: string;
}

function latexRows(text: string): Row[] {
  const [, inner = ''] = text.match(/\\begin\{aligned\}\n([\s\S]*)\n\\end\{aligned\}/) ?? [];
  return inner.split(' \\\\\n').map((row) => {
    const [left = '', right = ''] = row.trim().split('&');
    const [, math = '', words = ''] = right.match(/^(.*?)(?:(?:\\quad |^)\\text\{(.*)\})?$/) ?? [];
    const [, relation = '', rest = ''] =
      math.replaceAll('\\approx', '=').match(/^(=|<|\\le |)(.*)$/) ?? [];
    const chain = rest
      .replace(/\\quad $/, '')
      .split(' = ')
      .map((x) => x.trim());
    return { left: left.trim(), relation: relation.trim(), chain, words };
  });
}

function mathmlRows(text: string): Row[] {
  const [table] = elements(parseXml(text));
  if (!table) throw new Error('no table');
  return elements(table).map((row) => {
    expect(row.name).toBe('mtr');
    const cells = elements(row);
    expect(cells.map(({ name }) => name)).toEqual(['mtd', 'mtd', 'mtd', 'mtd']);
    const [left, relation, right] = cells.map(asLatex);
    const words = cells[3] ? textOf(cells[3]) : '';
    return {
      left: left ?? '',
      relation: relation === '≤' ? '\\le' : (relation ?? ''),
      chain: (right ?? '').split(/[=≈]/).map((x) => x.trim()),
      words,
    };
  });
}

/** What `display` writes, as both exports typeset it. */
const typeset = (x: number): string => typesetText(display(x));
const typesetText = (text: string): string =>
  plainPowers(text)
    .replace(/(· )?10\^(-?\d+)/, (_, dot, power) => `${dot ? '' : '1'}\\cdot10^{${power}}`)
    .replaceAll('−', '-')
    .replace('∞', '\\infty')
    .replace('no value', '\\text{novalue}')
    .replace(/\s/g, '');
const spaceless = (text: string): string => text.replace(/\s/g, '').replace(/_\{(\d)\}/g, '_$1');
/** Words of the LaTeX, as the page has them. */
const plain = (words: string): string =>
  words
    .replaceAll('$-$', '−')
    .replaceAll('$\\cdot$', '·')
    .replaceAll('$\\infty$', '∞')
    .replace(/\$_\{(\d)\}\$/g, (_, index: string) => subscript(Number(index)))
    .replace(/\$\^\{(-?\d+)\}\$/g, (_, power: string) => superscript(Number(power)));
const isWrittenOut = (x: number): boolean => Number.isFinite(x) && !display(x).includes('·');

/**
 * Of the derivation's own steps: symbols, numbers and value, each against the tree and the kernel's
 * number.
 */
function checkSteps({ derivation, found, exactly }: ExploreModel, rows: readonly Row[]): number {
  let checked = 0;
  for (const step of derivation.steps) {
    const letter = step.id.length === 1 ? step.id : null;
    const at = rows.findIndex(({ left }, row) =>
      letter ? left === letter && rows[row + 1]?.left === '' : reads(left, step.id),
    );
    const first = rows[at];
    expect(first, step.id).toBeDefined();
    const second = letter ? rows[at + 1] : first;
    if (!first || !second) continue;
    const symbols = letter ? first.chain[0] : first.left;
    const isPut = isWritable(step.expr, derivation.numbers, step.worked);
    const [put = '', value] = isPut ? second.chain : ['', second.chain[0]];
    if (step.value !== null) {
      const { text } = shownResult(step.id, step.value, found, exactly);
      expect(spaceless(value ?? ''), step.id).toBe(typesetText(text ?? display(step.value)));
    }
    if (!isPut) {
      checked++;
      continue;
    }
    for (const branch of [1, -1] as const) {
      const exact = evaluate(step.expr, float64, derivation.numbers, branch);
      if (!Object.values(derivation.numbers.scalars).every(Number.isFinite)) continue;
      expect(readLatex(symbols ?? '', derivation.numbers, branch), step.id).toBe(exact);
      if (!isWrittenOut(exact) || found.class === 'undecided') continue;
      // Six digits a number, and what cancellation makes of them.
      const read = readLatex(put, { scalars: {}, vectors: {} }, branch);
      expect(Math.abs(read - exact), `${step.id}: ${put}`).toBeLessThanOrEqual(
        1e-4 * Math.max(1, Math.abs(exact)),
      );
    }
    checked++;
  }
  return checked;
}

const reads = (left: string, id: string): boolean =>
  id === 'N.d' ? spaceless(left) === 'N\\cdotd' : /^N\\cdot\(E-[CP]\)$/.test(spaceless(left));

describe.each([
  ['LaTeX', 'exact'],
  ['LaTeX', 'textbook'],
  ['MathML', 'exact'],
  ['MathML', 'textbook'],
] as const)('%s, by %s', (format, method) => {
  const rowsOf = (model: ExploreModel): Row[] =>
    format === 'LaTeX' ? latexRows(derivationLatex(model)) : mathmlRows(derivationMathml(model));

  test.each(EXPORT_CASES)('$name: every step, its numbers and its value', (c) => {
    const model = modelOf(c, method);
    expect(checkSteps(model, rowsOf(model))).toBe(model.derivation.steps.length);
  });

  test.each(EXPORT_CASES)('$name: the verdict and every root, point and normal', (c) => {
    const model = modelOf(c, method);
    const { verdict, hits, found, derivation, contradicted } = model;
    const rows = rowsOf(model);
    const exactly = rows.map(({ words }) => words).filter((words) => words.startsWith('exact '));
    const others = [contradicted, model.ended?.contradicted ?? null].filter((one) => one !== null);
    expect(exactly.map(plain)).toEqual(others.map((one) => `exact arithmetic says: ${one}`));
    const verdictRow = rows.find(({ words }) => plain(words) === verdict.text);
    expect(verdictRow?.left).toBe('');
    expect(rows.filter(({ left }) => /^[tPN]_\d/.test(spaceless(left)))).toHaveLength(
      hits.filter(({ role }) => role !== 'outside').length * 3,
    );
    for (const { index, t, role, text } of hits) {
      const name = role === 'outside' ? 't' : `t_${index}`;
      const row = rows.find(({ left, words }) => spaceless(left) === name && words !== '');
      expect(spaceless(row?.chain[0] ?? '')).toBe(typeset(t));
      expect(plain(row?.words ?? '')).toBe(text);
    }
    found.hits.forEach(({ point, normal, singular }, i) => {
      const triple = (v: readonly number[]) => `(${v.map(typeset).join(',')})`;
      const at = (letter: string) =>
        rows.find(({ left }) => spaceless(left) === `${letter}_${i + 1}`)?.chain.map(spaceless);
      expect(at('P')).toEqual([`E+t_${i + 1}d`, triple(point)]);
      expect(at('N')).toEqual([singular ? '0' : triple(normal)]);
    });
    const told = rows.filter(({ words }) => /^(holds|fails|cannot tell)$/.test(words));
    expect(told.map(({ words }) => words)).toEqual(
      derivation.conditions.map(({ holds }) =>
        holds === null ? 'cannot tell' : holds ? 'holds' : 'fails',
      ),
    );
  });
});

describe.each(['exact', 'textbook'])('LaTeX is well formed, by %s', (method) => {
  test.each(EXPORT_CASES)('$name', (c) => {
    const text = derivationLatex(modelOf(c, method));
    expect(text).toMatch(/^[\n -~]*$/);
    expect(braceDepths(text)).toEqual({ lowest: 0, last: 0 });
    const open = [...text.matchAll(/\\begin\{(\w+)\}/g)].map(([, name]) => name);
    expect([...text.matchAll(/\\end\{(\w+)\}/g)].map(([, name]) => name)).toEqual(open.reverse());
    expect(text.match(/\\left[(|]/g)?.length).toBe(text.match(/\\right[)|]/g)?.length);
    // One alignment a row, no sign of a number that was not one.
    for (const row of text.split('\\\\\n')) expect(row.match(/(?<!\\)&/g)).toHaveLength(1);
    expect(text).not.toMatch(/NaN|Infinity|null|\[object/);
    expect(text).not.toContain('undefined');
    const commands = new Set(text.match(/\\[A-Za-z]+/g));
    expect([...commands].filter((name) => !KNOWN.has(name))).toEqual([]);
  });
});

/** LaTeX's own and amsmath's. */
const KNOWN = new Set(
  (
    '\\usepackage \\begin \\end \\frac \\sqrt \\pm \\cdot \\text \\quad \\le \\approx \\ne ' +
    '\\lvert \\rvert \\infty'
  ).split(' '),
);

function braceDepths(text: string): { lowest: number; last: number } {
  let depth = 0;
  let lowest = 0;
  for (const c of text.replace(/\\[{}]/g, '')) {
    depth += c === '{' ? 1 : c === '}' ? -1 : 0;
    lowest = Math.min(lowest, depth);
  }
  return { lowest, last: depth };
}

const python = spawnSync('python3', ['--version']).status === 0;

describe('MathML is well-formed XML', () => {
  test.each(EXPORT_CASES)('$name', (c) => {
    const { name, attributes } = parseXml(derivationMathml(modelOf(c)));
    expect(name).toBe('math');
    expect(attributes.xmlns).toBe('http://www.w3.org/1998/Math/MathML');
  });

  test.skipIf(!python)('by another parser too (skipped where there is no python3)', () => {
    const texts = EXPORT_CASES.map((c) => derivationMathml(modelOf(c)));
    const code =
      'import json, sys, xml.etree.ElementTree as e\nfor t in json.load(sys.stdin): ' +
      'e.fromstring(t)';
    const run = spawnSync('python3', ['-c', code], {
      input: JSON.stringify(texts),
      encoding: 'utf8',
    });
    expect(run.stderr).toBe('');
  });

  test('the parser notices what is wrong', () => {
    for (const bad of [
      '<a><b></a></b>',
      '<a>&x;</a>',
      '<a>',
      '<a/><b/>',
      '<a x=1/>',
      '<a>1 < 2</a>',
    ]) {
      expect(() => parseXml(bad), bad).toThrow();
    }
  });
});

test('the registry: every id once, every export a text for every case', { timeout: 60_000 }, () => {
  const ids = EXPORTS.map(({ id }) => id);
  expect([...new Set(ids)]).toEqual(ids);
  for (const c of EXPORT_CASES) {
    for (const { text, mime, extension } of EXPORTS) {
      expect(text(modelOf(c))).toMatch(/\S\n$/);
      expect(`${mime} ${extension}`).toMatch(/^\w+\/[\w.+-]+ [\w.]+$/);
    }
  }
});
