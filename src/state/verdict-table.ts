import type { Sign } from '../math/shapes.ts';

/** Where the roots are as seen from E, ascending: '−' behind it, '0' at E itself, '+' ahead. */
export type Side = '-' | '0' | '+';
export type Sides = '--' | '-0' | '-+' | '0+' | '++';

type Row<Key extends string> = Readonly<Record<Key, string>>;

/** f < 0 is inside. With A > 0 that is between the roots, with A < 0 outside of them. */
export const TWO: Readonly<Record<'-' | '+', Row<Sides>>> = {
  '+': {
    '++': 'two points: the ray enters, then leaves',
    '0+': 'two points: the ray enters at E itself, then leaves',
    '-+': 'two points: E is inside, the ray leaves',
    '-0': 'two points: one behind E, one at E itself, where the ray leaves',
    '--': 'two points, both behind E: the ray itself misses',
  },
  '-': {
    '++': 'two points: the ray leaves, then enters again',
    '0+': 'two points: the ray leaves at E itself, then enters again',
    '-+': 'two points: one behind E, one where the ray enters',
    '-0': 'two points: one behind E, one at E itself, where the ray enters',
    '--': 'two points, both behind E: the ray stays inside for ever',
  },
};

/** At a double root f keeps its sign: that of A. */
export const TOUCHES: Readonly<Record<'-' | '+', Row<Side>>> = {
  '+': {
    '+': 'tangent: one double root, the ray touches',
    '0': 'tangent: one double root, the ray touches at E itself',
    '-': 'tangent: one double root, behind E',
  },
  '-': {
    '+': 'tangent from inside: one double root, the ray touches and stays inside',
    '0': 'tangent from inside: one double root, at E itself, and the ray stays inside',
    '-': 'tangent from inside: one double root, behind E: the ray stays inside for ever',
  },
};

/** Double root at a `place` without a normal: a vertex, or a surface that is only an axis. */
export const SINGULAR: Readonly<Record<'-' | '+', (place: string) => Row<Side>>> = {
  '+': (place) => ({
    '+': `through ${place}: one double root, no normal there`,
    '0': `through ${place}, at E itself: one double root, no normal there`,
    '-': `through ${place}, behind E: one double root, no normal there`,
  }),
  '-': (place) => ({
    '+': `through ${place}, inside before and after it: one double root, no normal there`,
    '0': `through ${place}, at E itself, then inside for ever: one double root, no normal there`,
    '-': `through ${place}, behind E, inside for ever: one double root, no normal there`,
  }),
};

/** A = 0: f is a straight line, by the sign of its slope B. */
export const ONE: Readonly<Record<'-' | '+', Row<Side>>> = {
  '+': {
    '+': 'one point: E is inside, the ray leaves',
    '0': 'one point: E itself, where the ray leaves',
    '-': 'one point, behind E: the ray stays outside for ever',
  },
  '-': {
    '+': 'one point, where the ray enters',
    '0': 'one point: E itself, where the ray enters',
    '-': 'one point, behind E: the ray stays inside for ever',
  },
};

/** No root at all: f has one sign everywhere. */
export const NONE: Row<'-' | '+'> = {
  '+': 'no point: the ray misses',
  '-': 'no point: the ray stays inside for ever',
};

/** A = B = 0: f is the constant C. */
export const CONSTANT: Row<'-' | '+'> = {
  '+': 'outside for ever: no root',
  '-': 'inside for ever: no root',
};

/** End of the sentence on a flat shape: on which side of E the root is. */
export const WHERE: Row<Side> = { '+': '', '0': ', at E itself', '-': ', behind E' };

/** End of the sentence on a line in a figure's plane, by the sides of the stretch's two ends. */
export const STRETCH: Row<Sides> = {
  '++': '',
  '0+': ', starting at E itself',
  '-+': ', E in between',
  '-0': ', ending at E itself',
  '--': ', all of it behind E',
};

export const sideKey = (side: Sign): Side => (side < 0 ? '-' : side > 0 ? '+' : '0');
