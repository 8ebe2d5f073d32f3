import { expect, test } from 'vitest';
import { placeIn, sizeOf, zoomOf } from '../../../src/ui/zoom.ts';

/** Seen from (30, 60) on, at this zoom; a browser that knows none has no such property. */
const element = (zoom?: number): Element =>
  ({
    getBoundingClientRect: () => ({ left: 30, top: 60, width: 240, height: 120 }),
    ...(zoom === undefined ? {} : { currentCSSZoom: zoom }),
  }) as unknown as Element;

test('a pointer is placed in the element’s own pixels, whatever its zoom', () => {
  for (const zoom of [0.5, 1, 2]) {
    const at = { clientX: 30 + zoom * 12, clientY: 60 + zoom * 7 };
    expect(placeIn(element(zoom), at)).toEqual({ x: 12, y: 7 });
  }
});

test('a size is in the element’s own pixels too', () => {
  expect(sizeOf(element(2))).toEqual({ width: 120, height: 60 });
});

test('a browser without zoom has a factor of 1', () => {
  expect(zoomOf(element())).toBe(1);
  expect(placeIn(element(), { clientX: 42, clientY: 67 })).toEqual({ x: 12, y: 7 });
});
