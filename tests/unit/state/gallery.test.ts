import { describe, expect, test } from 'vitest';
import { createDerive } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { GALLERY } from '../../../src/state/gallery/index.ts';
import { decode } from '../../../src/state/url.ts';
import { holds, subjectOf } from './gallery-claims.ts';

test('each example is named once', () => {
  expect(new Set(GALLERY.map(({ id }) => id)).size).toBe(GALLERY.length);
});

/** Words that say something that can be false, and what must be claimed where they stand. */
const VOCABULARY: readonly (readonly [RegExp, RegExp])[] = [
  [/\bmiss(es)?\b/, /class none/],
  [/textbook formula says/, /^textbook class/],
  [/loses digits/, /digits right$/],
  [/\b(in place of)\b/, /^exact shows/],
  [/\btangent\b/, /class tangent/],
  [/\btouch(es|ing)\b/, /t1 touches/],
  [/\bdouble root\b/, /class tangent/],
  [/no normal|normal is zero/, /N1 is zero/],
  [/\bE is inside\b|\bfrom inside\b/, /^E inside$/],
  [/^inside$|lie between|within r of C/, /^P1 inside the figure$/],
  [/\benters?\b|^it enters|comes back in|in and out/, /t\d enters/],
  [/\bleaves?\b/, /t\d leaves/],
  [/behind E|negative\.$/, /t\d behind E/],
  [/\bahead\b(?! of)/, /t\d ahead/],
  [/visible hit/, /t2 ahead/],
  [/\bonce\b/, /class one/],
  [/\bone point\b/, /class one/],
  [/\btwo points\b(?! or)|\b[Tt]wo roots\b/, /class two/],
  [/\bno point\b|never zero/, /class none/],
  [/every t is a root|in the surface|whole line|in its plane|lies in the plane/, /class contained/],
  [/\brim\b|\bedge\b/, /limit|missed by/],
  [/belongs to/, /class one/],
  [/half a unit/, /missed by 0\.5/],
  [/beside the square/, /passes beside/],
  [/crosses it/, /crosses the figure/],
  [/lower nappe/, /(E|P1) below V/],
  [/upper (one|nappe)/, /P2 above V/],
  [/parallel to the axis/, /d along the axis/],
  [/generator|asymptot/, /generator$|d along the axis/],
  [/opens downwards/, /opens downwards/],
  [/straight line(?!s)/, /f straight/],
  [/straight lines/, /ruled/],
  [/constant/, /f constant/],
  [/right angle/, /right angle/],
  [/\bsphere\b/, /named sphere/],
  [/ellipsoid/, /named ellipsoid/],
  [/, cylinder,/, /named cylinder/],
  [/radius r/, /radius r|distance r/],
  [/epsilon|program/, /no root above/],
  [/far away/, /E beyond/],
  [/very far out/, /t2 beyond/],
  [/\bnear(est)? /, /near|within|digits/],
];

/** What the verdict and the graph say where this is claimed. */
const PAGE: readonly (readonly [RegExp, RegExp])[] = [
  [/^class (two|one)$/, /^(two|one) point|: one point/],
  [/^class tangent$/, /one double root/],
  [/^class none$/, /no point|no root/],
  [/^class contained$/, /lies in the (plane|surface)/],
  [/^N1 is zero$/, /no normal there/],
  [/^P1 at V$/, /through the vertex/],
  [/^E inside$/, /E is inside$/],
  [/^E outside$/, /E is outside$/],
  [/^d along the axis$/, /parallel to the axis|lies in the surface/],
  [/^d along a generator$/, /parallel to a generator|lies in the surface/],
  [/^P1 inside the figure$/, /inside the (circle|square)/],
  [/^P1 on 1 limit$/, /on the rim|on an edge/],
  [/^figure missed by 0.5$/, / 0.5 outside the circle/],
  [/^figure missed by 1.25$/, / 1.25 outside the square/],
  [/^crosses the figure/, /in the circle from t = /],
  [/^passes beside/, /passes beside the square/],
];

/** "A < 0", "D is exactly 0", "N·d = 0": the letter's claim, with the same relation. */
function letterClaims(words: string): string[] {
  const claims: string[] = [];
  for (const [, letter, relation, zero] of words.matchAll(
    /(?<![A-Za-z²])(A|B|C|D|N·d|N·\(E − P\)|a) (=|<|>|is exactly|is not)( 0| zero)(?![\d.])/g,
  )) {
    if (!zero) continue;
    const sign = { 'is exactly': '=', 'is not': '≠' }[relation as 'is not'] ?? relation;
    const name = { N·d: 'N.d', 'N·(E − P)': 'N.(E-P)' }[letter as 'N·d'] ?? letter;
    claims.push(`${name} ${sign} 0`);
  }
  return claims;
}

/** Numbers that are written out must come up in a claim: −2, 10⁻⁹, 3.75003. */
function numbersIn(words: string): string[] {
  const powers = [...words.matchAll(/10([⁻⁰¹²³⁴-⁹]+)/gu)].map(
    ([, up = '']) => `1e${[...up].map((c) => '-0123456789'['⁻⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(c)]).join('')}`,
  );
  const rest = words.replace(/10[⁻⁰¹²³⁴-⁹]+/gu, '');
  const plain = [...rest.matchAll(/(?<![\w²])−?\d+(\.\d+)?(?![\dA-Za-z])/g)].map(([n]) =>
    n.replace('−', '-'),
  );
  return [...powers, ...plain.filter((n) => n !== '0' || !/ 0/.test(rest))];
}

describe.each(GALLERY.map((entry) => [entry.id, entry] as const))('%s', (_, entry) => {
  const state = decode(entry.link);

  test('opens without complaint', () => expect(state.problems).toEqual([]));

  test('every claim holds, by exact arithmetic and as the page shows it', () => {
    const claims = entry.told.flatMap(([, ...all]) => all);
    const spoiled = claims.some((claim) => claim.startsWith('textbook'));
    expect(state.method === 'textbook').toBe(spoiled);
    for (const method of spoiled ? ['exact'] : ['exact', state.method]) {
      const subject = subjectOf(entry, method);
      expect(
        claims.filter((claim) => !holds(claim, subject)),
        method,
      ).toEqual([]);
    }
  });

  test('every clause has a claim for what its words say', () => {
    for (const [words, ...claims] of entry.told) {
      expect(claims.length, words).toBeGreaterThan(0);
      for (const [word, needed] of VOCABULARY) {
        if (word.test(words))
          expect(
            claims.filter((c) => needed.test(c)),
            `${words} ${needed}`,
          ).not.toEqual([]);
      }
      expect(claims, words).toEqual(expect.arrayContaining(letterClaims(words)));
      for (const number of numbersIn(words)) expect(claims.join(' '), words).toContain(number);
    }
  });

  test('the page beside it says the same', () => {
    const { verdict, graph } = createDerive(() => exploreDetails)(state);
    const said = `${verdict.text}; E is ${graph.stretches.find(({ from }) => from >= 0)?.place}`;
    for (const claim of entry.told.flatMap(([, ...all]) => all)) {
      const own = state.method === 'textbook' ? claim.replace(/^textbook /, '') : claim;
      if (own === claim && state.method === 'textbook') continue;
      for (const [kind, words] of PAGE) if (kind.test(own)) expect(said, claim).toMatch(words);
    }
  });

  test('asks one question, and answers it in one sentence', () => {
    expect(entry.asks).toMatch(/^[^.?!]+\?$/);
    expect(entry.answer.endsWith('.')).toBe(true);
    expect(entry.answer.split(/\.\s/)).toHaveLength(1);
  });
});

test('every shape of it is hit in an example, and every class appears', () => {
  const found = GALLERY.map((entry) => subjectOf(entry, 'exact'));
  const hit = found.filter((one) => one.found.hits.length > 0).map(({ shape }) => shape.kind);
  expect(new Set(hit)).toEqual(new Set(found.map(({ shape }) => shape.kind)));
  expect(new Set(found.map((one) => one.found.class)).size).toBe(5);
});
