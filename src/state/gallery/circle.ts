import { type Example, example } from './define.ts';

export const CIRCLE: readonly Example[] = [
  example(
    'circle-hit',
    ['inside', 'P1 inside the figure'],
    [
      ['First the plane,', 'N.d ≠ 0', 't1 ahead'],
      [
        'then the question whether the point is within r of C.',
        'P1 inside the figure',
        '1 condition',
      ],
    ],
    'shape=circle&N=1,0.5,0&C=0,1,0&r=2&E=3,1,1&d=-0.75,-0.5,-0.25',
  ),
  example(
    'circle-rim',
    ['on the rim', 'P1 on 1 limit'],
    [
      ['|P₁ − C| is exactly r:', 'P1 on 1 limit'],
      ['the rim belongs to the circle.', 'class one', 'P1 on 1 limit'],
    ],
    'shape=circle&N=1,0,0&C=0,1,0&r=2&E=3,1,2&d=-1,0,0',
  ),
  example(
    'circle-outside',
    ['beside it', 'class none', 'figure missed by 0.5'],
    [
      [
        'The plane is met, but half a unit outside the rim: no point.',
        'N.d ≠ 0',
        'figure missed by 0.5',
        'class none',
      ],
    ],
    'shape=circle&N=1,0,0&C=0,1,0&r=2&E=3,1,2.5&d=-1,0,0',
  ),
  example(
    'circle-contained',
    ['in its plane', 'class contained'],
    [
      [
        'The ray lies in the plane of the circle and crosses it:',
        'class contained',
        'crosses the figure ahead',
      ],
      ['a whole stretch of points, and no single one.', 'crosses the figure ahead'],
    ],
    'shape=circle&N=1,0,0&C=0,1,0&r=2&E=0,1.5,4&d=0,0,-1',
  ),
];
