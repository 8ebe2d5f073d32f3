import { type Example, example } from './define.ts';

export const SQUARE: readonly Example[] = [
  example('square-hit', {
    title: ['inside', 'P1 inside the figure'],
    asks: ['How many comparisons does a square need?', '4 conditions'],
    answer: [
      ['Four comparisons decide:', '4 conditions'],
      [
        'both coordinates in the plane lie between P and P + L.',
        'P1 inside the figure',
        't1 ahead',
      ],
    ],
    view: { azimuth: 32, elevation: 16, zoom: null },
    outside: [],
    link: 'shape=square&P=0,0,-1&L=2&axis=x&E=3,1,1&d=-0.75,-0.125,-0.25',
  }),
  example('square-edge', {
    title: ['on an edge', 'P1 on 1 limit'],
    asks: ['Does a point on an edge count?', 'P1 on 1 limit'],
    answer: [
      ['y is exactly Py + L:', 'P1.y = P.y + L'],
      ['the edge belongs to the square.', 'class one', 'P1 on 1 limit'],
    ],
    view: { azimuth: 36, elevation: 16, zoom: null },
    outside: [],
    link: 'shape=square&P=0,0,-1&L=2&axis=x&E=3,2,0&d=-1,0,0',
  }),
  example('square-outside', {
    title: ['past a corner', 'class none', '2 conditions fail'],
    asks: ['From where is the distance measured beyond a corner?', '2 conditions fail'],
    answer: [
      [
        'Beyond a corner the distance is measured to the corner, not to a side.',
        '2 conditions fail',
        'figure missed by 1.25',
        '1.25 from a corner',
      ],
    ],
    view: { azimuth: 36, elevation: 16, zoom: null },
    outside: [],
    link: 'shape=square&P=0,0,-1&L=2&axis=x&E=3,2.75,2&d=-1,0,0',
  }),
  example('square-floor', {
    title: ['lying down', 'normal along y'],
    asks: ['Which coordinates are compared when the normal is along y?', 'normal along y'],
    answer: [
      [
        'With the normal along y the square is a floor,',
        'normal along y',
        'P1 inside the figure',
        't1 ahead',
      ],
      ['and x and z are compared.', 'x and z compared'],
    ],
    view: { azimuth: 20, elevation: 26, zoom: null },
    outside: [],
    link: 'shape=square&P=-1,0,-1&L=2&axis=y&E=3,2,1&d=-0.75,-0.5,-0.25',
  }),
  example('square-contained', {
    title: ['in its plane', 'class contained'],
    asks: [
      'Every t solves the equation: is one of them a point of the square?',
      'N.d = 0',
      'N.(E-P) = 0',
      'passes beside the figure',
    ],
    answer: [
      [
        'The ray lies in the plane and passes beside the square:',
        'class contained',
        'passes beside the figure',
      ],
      [
        'every t solves the equation, and none gives a point of the square.',
        'N.d = 0',
        'N.(E-P) = 0',
        'passes beside the figure',
      ],
    ],
    view: { azimuth: 20, elevation: 32, zoom: null },
    outside: [],
    link: 'shape=square&P=-1,0,-1&L=2&axis=y&E=3,0,2&d=-1,0,0',
  }),
];
