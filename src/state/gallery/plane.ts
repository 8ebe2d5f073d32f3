import { type Example, example } from './define.ts';

export const PLANE: readonly Example[] = [
  example(
    'plane-hit',
    ['one point', 'class one'],
    [
      ['N·d is not zero,', 'N.d ≠ 0'],
      ['so the line meets the plane once:', 'class one'],
      ['f(t) is a straight line.', 'f straight'],
    ],
    'shape=plane&N=0,1,0&P=0,0,0&E=3,3,1&d=-1,-1,0',
  ),
  example(
    'plane-behind',
    ['behind E', 't1 behind E'],
    [
      ['The root is −2:', 't1 = -2'],
      ['the line meets the plane, the ray does not.', 'class one', 't1 behind E'],
    ],
    'shape=plane&N=0,1,0&P=0,0,0&E=2,2,1&d=-1,1,0',
  ),
  example(
    'plane-parallel',
    ['parallel', 'N.d = 0', 'class none'],
    [
      ['N·d = 0 and E is off the plane:', 'N.d = 0', 'N.(E-P) ≠ 0'],
      ['f(t) is constant and never zero.', 'f constant', 'class none'],
    ],
    'shape=plane&N=0,1,0&P=0,0,0&E=3,1,1&d=-1,0,0',
  ),
  example(
    'plane-contained',
    ['in the plane', 'class contained'],
    [
      ['N·d = 0 and N·(E − P) = 0:', 'N.d = 0', 'N.(E-P) = 0'],
      ['every t is a root, so no single one is the answer.', 'class contained'],
    ],
    'shape=plane&N=0,1,0&P=0,0,0&E=3,0,1&d=-1,0,0.25',
  ),
  example(
    'plane-grazing',
    ['at a flat angle', 'angle to the plane < 2°'],
    [
      ['N·d is small:', 'N.d ≠ 0', 'angle to the plane < 2°'],
      [
        'halving it moves the point from x = −1 to x = −5.',
        'P1.x = -1',
        'with d.y -0.015625: P1.x = -5',
      ],
    ],
    'shape=plane&N=0,1,0&P=0,0,0&E=3,0.125,1&d=-1,-0.03125,0',
  ),
];
