import { type Example, example } from './define.ts';

export const PLANE: readonly Example[] = [
  example('plane-hit', {
    title: ['one point', 'class one'],
    asks: [
      'What must N·d not be for the line to have one point with the plane?',
      'N.d ≠ 0',
      'class one',
    ],
    answer: [
      ['N·d is not zero,', 'N.d ≠ 0'],
      ['so the line meets the plane once:', 'class one'],
      ['f(t) is a straight line.', 'f straight'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=plane&N=0,1,0&P=0,0,0&E=3,3,1&d=-1,-1,0',
  }),
  example('plane-behind', {
    title: ['behind E', 't1 behind E'],
    asks: ['The line meets the plane: does the ray?', 'class one', 't1 behind E'],
    answer: [
      ['The root is −2:', 't1 = -2'],
      ['the line meets the plane, the ray does not.', 'class one', 't1 behind E'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=plane&N=0,1,0&P=0,0,0&E=2,2,1&d=-1,1,0',
  }),
  example('plane-parallel', {
    title: ['parallel', 'N.d = 0', 'class none'],
    asks: [
      'What is N·d for a ray that keeps its distance from the plane?',
      'N.d = 0',
      'class none',
    ],
    answer: [
      ['N·d = 0 and E is off the plane:', 'N.d = 0', 'N.(E-P) ≠ 0'],
      ['f(t) is constant and never zero.', 'f constant', 'class none'],
    ],
    view: { azimuth: 12, elevation: 7, zoom: null },
    outside: [],
    link: 'shape=plane&N=0,1,0&P=0,0,0&E=3,1,1&d=-1,0,0',
  }),
  example('plane-contained', {
    title: ['in the plane', 'class contained'],
    asks: ['Which t solve the equation when the ray runs in the plane?', 'class contained'],
    answer: [
      ['N·d = 0 and N·(E − P) = 0:', 'N.d = 0', 'N.(E-P) = 0'],
      ['every t is a root, so no single one is the answer.', 'class contained'],
    ],
    view: { azimuth: 16, elevation: 28, zoom: null },
    outside: [],
    link: 'shape=plane&N=0,1,0&P=0,0,0&E=3,0,1&d=-1,0,0.25',
  }),
  example('plane-grazing', {
    title: ['at a flat angle', 'angle to the plane < 2°'],
    asks: [
      'How far does the point move when N·d is halved?',
      'with d.y -0.015625: P1.x = -5',
      'P1.x = -1',
    ],
    answer: [
      ['N·d is small:', 'N.d ≠ 0', 'angle to the plane < 2°'],
      [
        'halving it moves the point from x = −1 to x = −5.',
        'P1.x = -1',
        'with d.y -0.015625: P1.x = -5',
      ],
    ],
    view: { azimuth: 10, elevation: 8, zoom: null },
    outside: [],
    link: 'shape=plane&N=0,1,0&P=0,0,0&E=3,0.125,1&d=-1,-0.03125,0',
  }),
];
