import { type Example, example } from './define.ts';

export const CIRCLE: readonly Example[] = [
  example('circle-hit', {
    title: ['inside', 'P1 inside the figure'],
    asks: ['The plane is met: what is asked next?', 'N.d ≠ 0', 'class one'],
    answer: [
      ['First the plane,', 'N.d ≠ 0', 't1 ahead'],
      [
        'then the question whether the point is within r of C.',
        'P1 inside the figure',
        '1 condition',
      ],
    ],
    view: { azimuth: 30, elevation: 14, zoom: null },
    outside: [],
    link: 'shape=circle&N=1,0.5,0&C=0,1,0&r=2&E=3,1,1&d=-0.75,-0.5,-0.25',
  }),
  example('circle-rim', {
    title: ['on the rim', 'P1 on 1 limit'],
    asks: ['Does a point on the rim count?', 'P1 on 1 limit'],
    answer: [
      ['|P₁ − C| is exactly r:', 'P1 on 1 limit'],
      ['the rim belongs to the circle.', 'class one', 'P1 on 1 limit'],
    ],
    view: { azimuth: 36, elevation: 14, zoom: null },
    outside: [],
    link: 'shape=circle&N=1,0,0&C=0,1,0&r=2&E=3,1,2&d=-1,0,0',
  }),
  example('circle-outside', {
    title: ['beside it', 'class none', 'figure missed by 0.5'],
    asks: ['The plane is met: why is there no point?', 'N.d ≠ 0', 'class none'],
    answer: [
      [
        'The plane is met, but half a unit outside the rim: no point.',
        'N.d ≠ 0',
        'figure missed by 0.5',
        'class none',
      ],
    ],
    view: { azimuth: 36, elevation: 14, zoom: null },
    outside: [],
    link: 'shape=circle&N=1,0,0&C=0,1,0&r=2&E=3,1,2.5&d=-1,0,0',
  }),
  example('circle-contained', {
    title: ['in its plane', 'class contained'],
    asks: [
      'How much of the ray does the circle in its own plane take?',
      'class contained',
      'crosses the figure ahead',
    ],
    answer: [
      [
        'The ray lies in the plane of the circle and crosses it:',
        'class contained',
        'crosses the figure ahead',
      ],
      ['a whole stretch of points, and no single one.', 'crosses the figure ahead'],
    ],
    view: { azimuth: 58, elevation: 14, zoom: null },
    outside: [],
    link: 'shape=circle&N=1,0,0&C=0,1,0&r=2&E=0,1.5,4&d=0,0,-1',
  }),
];
