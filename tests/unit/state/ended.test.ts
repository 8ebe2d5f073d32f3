import { describe, expect, test } from 'vitest';
import { withAttributes } from '../../../src/embed/attributes.ts';
import { freedomOf } from '../../../src/lesson/freedom.ts';
import { intersect, SHAPES, type Shape, type Solid } from '../../../src/math/index.ts';
import { integer, seeded } from '../../../src/math/rng.ts';
import { announcement } from '../../../src/state/announce.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { fromFile, toFile } from '../../../src/state/file.ts';
import { advance, historyOf } from '../../../src/state/history.ts';
import { answerOf } from '../../../src/state/host-messages.ts';
import { judgementOf, QUESTIONS } from '../../../src/state/predictions.ts';
import { type AppState, INITIAL, initialShape, PAGES } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { decode, encode } from '../../../src/state/url.ts';

const derive = createDerive(() => exploreDetails);
const open = (query: string): AppState => decode(`#/explore?${query}`, INITIAL);
const CAN = 'shape=cylinder&E=3,4,1&d=-1,-1,-0.3&C=0,1,0&r=1.5&between=0,2';

const curved = SHAPES.filter(
  (entry) => entry.formula(initialShape(entry.kind) as never).family === 'curved',
);

/** Half-integers, so that rims, tangents and roots at E come up. */
function draw(seed: number, kind: Shape['kind']): AppState {
  const random = seeded(seed);
  const half = (): number => integer(random, -6, 6) / 2;
  const triple = () => [half(), half(), half()] as const;
  const d = triple();
  const low = half();
  return {
    ...INITIAL,
    kind,
    E: triple(),
    d: d.some((x) => x !== 0) ? d : [0, 1, 0],
    between: [low, low + 0.5 + integer(random, 0, 6) / 2],
    caps: integer(random, 0, 1) === 1,
  };
}

describe.each(curved.map(({ kind }) => kind))('%s', (kind) => {
  test('scene, graph, table and words say what the module says', () => {
    for (let seed = 0; seed < 300; seed++) {
      const state = draw(seed, kind);
      const model = derive(state);
      const solid = { ...model.shape, between: state.between, caps: state.caps } as Solid;
      const { hits } = intersect(solid, model.ray, state.method);
      const about = JSON.stringify({ seed, hits });
      const cut = hits.filter(({ fate }) => fate === 'cut').map(({ t }) => t);
      const left = hits.filter(({ fate }) => fate !== 'cut');
      const marks = [...model.graph.roots, ...model.graph.caps];
      expect(
        model.hits.filter(({ role }) => role === 'cut').map(({ t }) => t),
        about,
      ).toEqual(cut);
      for (const all of [model.scene.hits, marks] as const) {
        const now = all.filter(({ role }) => role !== 'cut').map(({ t }) => t);
        expect(
          now.sort((a, b) => a - b),
          about,
        ).toEqual(left.map(({ t }) => t));
        const [first, ...more] = all.filter(({ role }) => role === 'first');
        expect(more).toEqual([]);
        const seen = left.find(({ t }) => t > 0)?.t;
        // A root that rounds to 0 may be behind E; this grid has none but E itself.
        const atE = left.find(({ t }) => t === 0)?.t;
        expect(first?.t, about).toBe(atE ?? seen);
      }
      expect(model.verdict.text, about).toContain('uncut, ');
      expect(/ (is|are) cut off/.test(model.verdict.text), about).toBe(cut.length > 0);
      expect(model.verdict.text.includes('nothing is hit'), about).toBe(
        left.length === 0 && model.found.class !== 'contained',
      );
      for (const { isHit, at, end } of model.ended?.capLines ?? []) {
        const own = hits.find(
          ({ fate, normal }) => fate === 'cap' && (normal[1] > 0 ? 'high' : 'low') === end,
        );
        expect(isHit, about).toBe(own !== undefined);
        if (own) expect(at?.t, about).toBeCloseTo(own.t, 12);
        if (at && !isHit && model.found.class !== 'contained') expect(at.side >= 0).toBe(true);
      }
      // Inside is where f < 0 between the heights.
      for (const { from, to, place } of model.graph.stretches) {
        const t = (from + to) / 2;
        const y = state.E[1] + t * state.d[1];
        const [low, high] = state.between ?? [0, 0];
        if (place === 'inside') expect(y >= low && y <= high, about).toBe(true);
      }
    }
  });

  test('what is drawn is between the heights, the rims and discs at them', () => {
    for (let seed = 0; seed < 60; seed++) {
      const { scene, state } = derive({ ...draw(seed, kind), caps: true });
      const [low, high] = state.between ?? [0, 0];
      for (const patch of scene.drawing.patches) {
        for (const v of [0, 0.3, 0.7, 1]) {
          const [, y] = patch.at(0.2, v);
          expect(y).toBeGreaterThanOrEqual(low);
          expect(y).toBeLessThanOrEqual(high);
        }
      }
      const ends = scene.handles.filter(({ symbol }) => symbol === 'low' || symbol === 'high');
      expect(ends.map(({ value }) => value)).toEqual([low, high]);
      const [lower] = ends;
      expect(lower?.refusal(high)).toContain('low must be below high');
      const moved = update(state, lower?.action(low - 1) as never);
      expect(moved.between).toEqual([low - 1, high]);
    }
  });
});

test('the first hit of a can from above is on its upper cap; its walls are cut off there', () => {
  const { verdict, scene, graph, hits } = derive(open(`${CAN}&caps=1`));
  expect(verdict.text).toBe(
    'uncut, two points: the ray enters, then leaves; cut at heights 0 and 2, capped: ' +
      't₁ and t₂ are cut off, first hit at t = 2 on the upper cap',
  );
  expect(hits.map(({ text }) => text)).toEqual([
    'cut off: y = 2.406 > 2',
    'cut off: y = −0.4613 < 0',
  ]);
  expect(scene.hits.map(({ words }) => words)).toEqual([
    't₁ cut off',
    't₂ cut off',
    'upper cap',
    'lower cap',
  ]);
  expect(scene.description).toContain('On the upper cap at t = 2, first hit, enters');
  expect(graph.caps.map(({ t }) => t)).toEqual([2, 4]);
});

test('ends stay through edits, undo, files, links, other shapes and attributes', () => {
  const state = open(`${CAN}&caps=1`);
  expect(state.problems).toEqual([]);
  const ends = ({ between, caps }: AppState) => ({ between, caps });
  const same = ends(state);
  // A reload of any page about the ray leads back to the same shape.
  for (const { id } of PAGES.filter(({ ray }) => ray)) {
    expect(ends(decode(encode({ ...state, page: id }), INITIAL)), id).toEqual(same);
  }
  const file = fromFile(toFile(state));
  expect(file.ok && ends(file.state)).toEqual(same);
  const flat = update(state, { type: 'shape', kind: 'plane' });
  const kept = fromFile(toFile(flat));
  expect(kept.ok && ends(kept.state)).toEqual(same);
  expect(derive(flat).ended).toBeNull();
  let history = historyOf(state);
  history = advance(history, { type: 'ends', value: null }, null);
  expect(ends(history.present)).toEqual({ between: null, caps: false });
  history = advance(history, { type: 'origin', value: [9, 9, 9] }, null);
  history = advance(advance(history, { type: 'undo' }, null), { type: 'undo' }, null);
  expect(ends(history.present)).toEqual(same);
  expect(ends(advance(history, { type: 'redo' }, null).present).between).toBeNull();
  const host = withAttributes(
    open('shape=cone'),
    new Map([
      ['between', '-1,2'],
      ['caps', ''],
    ]),
  );
  expect(ends(host)).toEqual({ between: [-1, 2], caps: true });
  expect(host.problems).toEqual([]);
  expect(ends(withAttributes(host, new Map([['between', null]]))).between).toBeNull();
});

test('what is no pair of ends changes nothing, and is said in a link', () => {
  const state = open(CAN);
  for (const between of [
    [2, 0],
    [1, 1],
    [0, Number.POSITIVE_INFINITY],
    [Number.NaN, 1],
  ] as const) {
    expect(update(state, { type: 'ends', value: { between, caps: false } })).toBe(state);
  }
  expect(update(state, { type: 'ends', value: (now) => now })).toBe(state);
  expect(open('caps=1').problems).toEqual([
    "opened without caps: 'caps' needs 'between', which is missing",
  ]);
  expect(open('between=0,1&caps=yes').problems.join()).toContain("'yes' is not 0 or 1");
  const locked = open(`${CAN}&lock=between`);
  expect(locked.problems).toEqual([]);
  expect(update(locked, { type: 'ends', value: null })).toBe(locked);
  expect(derive(locked).scene.handles.map(({ symbol }) => symbol)).not.toContain('low');
});

test('a lesson may let an end be moved', () => {
  const state = open(CAN);
  const [free] = freedomOf('high', state) ?? [];
  expect(free?.valueIn(state)).toBe(2);
  expect(free?.allows(-1, state)).toBe(false);
  expect(free && update(state, free.action(3)).between).toEqual([0, 3]);
  expect(freedomOf('high', INITIAL)).toBeNull();
});

test('hosts are told the fates', () => {
  const state = open(`${CAN}&caps=1`);
  expect(answerOf(state, derive(state)).fates?.map(({ fate }) => fate)).toEqual([
    'cut',
    'cap',
    'cap',
    'cut',
  ]);
  expect(answerOf(INITIAL, derive(INITIAL))).not.toHaveProperty('fates');
});

test('a prediction of the first hit is judged by what the ends leave', () => {
  const model = derive(open(`${CAN}&caps=1`));
  const [first, where] = ['first', 'where'].map((id) => QUESTIONS.find((one) => one.id === id));
  if (!first || !where) throw new Error('two questions were expected');
  expect(judgementOf(first, 'high', model)).toMatchObject({ right: true, mistake: null });
  expect(judgementOf(first, 't1', model)).toMatchObject({ right: false, truth: 'high' });
  expect(judgementOf(where, 2, model).right).toBe(true);
  const away = derive(open(`${CAN}&d=1,1,0`));
  expect(judgementOf(first, 'none', away).right).toBe(true);
});

test('each change of the ends is said, with what follows from it', () => {
  const state = open(CAN);
  const ends = (between: readonly [number, number], caps: boolean) =>
    derive(update(state, { type: 'ends', value: { between, caps } }));
  const whole = derive(update(state, { type: 'ends', value: null }));
  const [finite, closed, lower] = [ends([0, 2], false), ends([0, 2], true), ends([-1, 2], true)];
  expect(announcement(whole, finite)).toMatch(/^low 0\. high 2\. Open ends\. Now uncut, /);
  expect(announcement(finite, closed)).toMatch(
    /^Closed by caps\. Now .*upper cap 2, lower cap 4\.$/,
  );
  expect(announcement(closed, lower)).toMatch(/^low −1\. /);
  expect(announcement(closed, whole)).toMatch(/^The cylinder is whole\. /);
});

test('where a method is wrong about an end, exact arithmetic’s answer stands beside it', () => {
  // y at the root is 2 + 2⁻⁶⁰: rounded it is on the rim, which belongs to the shape.
  const state = open(`shape=cylinder&E=-10,2,0&d=1,1e-18,0&C=0,0,0&r=1&between=0,2`);
  const by = (method: string) => derive({ ...state, method }).ended;
  expect(by('certified')?.text).toBe('t₁ and t₂ are cut off, nothing is hit');
  expect(by('certified')?.contradicted).toBeNull();
  expect(by('certified')?.cut[0]).toContain('rounds to 2');
  expect(by('textbook')?.text).toBe('first hit t₁');
  expect(by('textbook')?.contradicted).toBe('t₁ and t₂ are cut off, nothing is hit');
});

test('before the code of ends is there nothing is said of the result', () => {
  const { waiting, shown } = createDerive()(open(CAN));
  expect(waiting).toBe(true);
  expect([shown.verdict, shown.hits]).toEqual([false, false]);
  expect(createDerive()(INITIAL).waiting).toBe(false);
});
