import { expect, test } from 'vitest';
import { createMapper } from '../../../../src/lab/atlas/map.ts';
import { MARKS, markByte, VERDICTS } from '../../../../src/lab/atlas/marks.ts';
import { SHAPES } from '../../../../src/math/index.ts';
import { definitionOf } from '../../../../src/math/shapes.ts';
import { many } from '../../many.ts';
import { somePixels, tour } from './tour.ts';

const WINDOWS = 1000;
/** Of each window: every night four times as many windows, and more of each. */
const PIXELS = somePixels(process.env.LONG ? 4096 : 128);

test(`certified's own map is empty: a tour of ${WINDOWS} windows, against exact arithmetic`, () => {
  const crossed = new Map<string, number>();
  const visited = new Set<string>();
  let asked = 0;
  for (const request of tour(2026, many(WINDOWS), 'exact')) {
    // Exact's map has certified's verdicts and roots to compare with: what differs is a mark.
    const part = createMapper(request).part(PIXELS);
    const failing = [...part.pixels].filter((_, i) => {
      const mark = MARKS[part.marks[i] as number];
      return mark !== 'nothing' && (mark !== 'right' || part.lost[i] !== 0);
    });
    expect(failing, JSON.stringify(request)).toEqual([]);
    const own = createMapper({ ...request, method: 'certified' }).part(PIXELS);
    expect(own.said).toEqual(part.said);
    expect(own.marks).toEqual(part.marks);
    visited.add(request.shape.kind);
    asked += part.marks.filter((mark) => mark !== markByte('nothing')).length;
    const formula = definitionOf(request.shape).formula(request.shape);
    const withRay = [...part.pixels.keys()].filter((i) => part.marks[i] !== markByte('nothing'));
    const leading = new Set(withRay.map((i) => part.leading[i]));
    const classes = new Set(withRay.map((i) => VERDICTS[part.truth[i] as number]));
    const count = (border: string, has: boolean): void => {
      if (has) crossed.set(border, (crossed.get(border) ?? 0) + 1);
    };
    if (formula.family === 'curved') {
      count('D = 0', classes.has('two') && classes.has('none'));
      count('A = 0', leading.size > 1);
    } else {
      count('N·d = 0', leading.size > 1);
      count('rim', formula.bound !== null && classes.has('one') && classes.has('none'));
    }
  }
  expect(visited).toEqual(new Set(SHAPES.map(({ kind }) => kind)));
  expect([...crossed.keys()].sort()).toEqual(['A = 0', 'D = 0', 'N·d = 0', 'rim']);
  expect(asked).toBeGreaterThan(many(WINDOWS) * 32);
});
