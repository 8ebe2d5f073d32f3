import { readdirSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { findFamily } from '../../../src/math/families.ts';
import { intersect } from '../../../src/math/index.ts';
import { seeded } from '../../../src/math/rng.ts';
import { codeSpans, ROOT, read, section } from './documents.ts';

const numerics = read('docs/NUMERICS.md');

describe('docs/NUMERICS.md', () => {
  test('every file that it names without a folder is in src/math', () => {
    const files = readdirSync(new URL('src/math', ROOT), { recursive: true, encoding: 'utf8' });
    const names = files.map((path) => path.split(/[\\/]/).at(-1) ?? '');
    const isThere = (name: string): boolean => {
      const pattern = new RegExp(`^${name.replace('.', '\\.').replace('*', '.*')}$`);
      return names.some((one) => pattern.test(one));
    };
    const named = codeSpans(numerics).filter((span) => /^[\w*-]+\.ts$/.test(span));
    expect(named.length).toBeGreaterThan(10);
    expect(named.filter((name) => !isThere(name))).toEqual([]);
  });

  test('it names every file of certified', () => {
    const files = readdirSync(new URL('src/math/methods/certified', ROOT));
    const named = new Set(codeSpans(numerics));
    expect(files.filter((name) => name.endsWith('.ts') && !named.has(name))).toEqual([]);
  });

  const rows = [...section(numerics, '## 3. Where digits go').matchAll(/^\| (.*) \|$/gm)].map(
    ([, row = '']) => row.split(' | '),
  );
  const [head = [], ...families] = rows;
  const methods = head.flatMap((cell, place) => {
    const [id] = codeSpans(cell);
    return id === undefined ? [] : [{ id, place }];
  });

  test('has a table of where digits go', () => {
    expect(methods.length).toBeGreaterThan(1);
    expect(families.length).toBeGreaterThan(2);
  });

  test.each(families.map((row) => [row[0], row] as const))('the digits lost: %s', (_, row) => {
    const [id = ''] = codeSpans(row[1] ?? '');
    const ids = methods.map((method) => method.id);
    const lost = medianLosses(id, Number(row[2]), ids).map((bits) => bits.toFixed(0));
    expect(methods.map(({ place }) => row[place])).toEqual(lost);
  });
});

/** Bits that each method loses of the root nearest to t = 0, where its class is right. */
function medianLosses(family: string, dial: number, ids: readonly string[]): readonly number[] {
  const random = seeded(2026);
  const losses = ids.map((): number[] => []);
  for (let k = 0; k < 500; k++) {
    const { shape, ray } = findFamily(family)?.make(random, dial) ?? {};
    if (!shape || !ray) throw new Error(`no family ${family}`);
    const exact = intersect(shape, ray, 'exact');
    const [t0, t1] = exact.hits.map(({ t }) => t);
    if (t0 === undefined || t1 === undefined) continue;
    const near = Math.abs(t0) < Math.abs(t1) ? 0 : 1;
    const t = near === 0 ? t0 : t1;
    ids.forEach((id, i) => {
      const { class: verdict, hits } = intersect(shape, ray, id);
      const got = hits[near]?.t ?? 0;
      if (verdict !== exact.class) return;
      losses[i]?.push(got === t ? 0 : Math.max(0, 53 + Math.log2(Math.abs((got - t) / t))));
    });
  }
  return losses.map((all) => all.sort((a, b) => a - b)[all.length >> 1] ?? Number.NaN);
}
