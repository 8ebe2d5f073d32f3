import { type Example, example } from './define.ts';

export const HYPERBOLOID: readonly Example[] = [
  example(
    'hyperboloid-hit',
    ['through the waist', 'P1 within 0.5 of the waist', 'P2 within 0.5 of the waist'],
    [
      [
        'The ray enters and leaves near the waist,',
        't1 ahead',
        't1 enters',
        't2 leaves',
        'P1 within 0.5 of the waist',
        'P2 within 0.5 of the waist',
      ],
      ['where the radius is r.', 'radius r at the waist'],
    ],
    'shape=hyperboloid&C=0,0.25,0&a=0.4&r=1&E=3,1,1&d=-0.8,-0.2,-0.3',
  ),
  example(
    'hyperboloid-miss',
    ['past the waist', 'class none', 'E outside', 'd level', 'E at the height of the waist'],
    [
      [
        'At the height of the waist the ray passes by;',
        'class none',
        'E outside',
        'd level',
        'E at the height of the waist',
      ],
      [
        'two units higher or lower it would hit.',
        'with E.y 3: class two',
        'with E.y -1: class two',
      ],
    ],
    'shape=hyperboloid&C=0,1,0&a=0.5&r=1&E=3,1,1.5&d=-1,0,0&view=ray',
  ),
  example(
    'hyperboloid-out-in',
    ['out and in again', 't1 leaves', 't2 enters', 't1 ahead'],
    [
      ['A < 0:', 'A < 0'],
      ['the steep ray leaves below the waist', 't1 ahead', 't1 leaves', 'P1 below the waist'],
      ['and comes back in above it.', 't2 enters', 'P2 above the waist'],
    ],
    'shape=hyperboloid&C=0,1,0&a=0.5&r=0.5&E=1.25,-1,0&d=-0.125,1,0',
  ),
  example(
    'hyperboloid-parallel',
    ['parallel to the asymptote', 'd along a generator', 'class one'],
    [
      ['A = 0:', 'A = 0'],
      ['the ray is parallel to a line of the asymptotic cone', 'd along a generator'],
      ['and meets the surface once.', 'class one', 't1 ahead'],
    ],
    'shape=hyperboloid&C=0,1,0&a=1&r=1&E=3,3,0.5&d=-1,-1,0',
  ),
  example(
    'hyperboloid-ruling',
    ['a line in the surface', 'class contained'],
    [
      ['This curved surface is full of straight lines,', 'ruled'],
      ['and the ray is one of them.', 'class contained'],
    ],
    'shape=hyperboloid&C=0,1,0&a=1&r=1&E=1,-1,-2&d=0,1,1',
  ),
  example(
    'hyperboloid-cylinder',
    ['a is 0', 'a = 0'],
    [
      [
        'Slide a through 0: hyperboloid, cylinder, ellipsoid,',
        'with a 0.05: named hyperboloid',
        'named cylinder',
        'with a -0.05: named ellipsoid',
      ],
      [
        'and the same formula gives two points.',
        'with a 0.05: class two',
        'class two',
        'with a -0.05: class two',
      ],
    ],
    'shape=hyperboloid&C=0,1,0&a=0&r=1.5&E=3,2,1&d=-1,-0.25,-0.25',
  ),
  example(
    'hyperboloid-ellipsoid',
    ['an ellipsoid', 'named ellipsoid'],
    [
      ['a < 0 closes the surface:', 'a < 0', 'bounded'],
      ['A can no longer be 0, so a line has two points or one or none.', 'A > 0 for every d'],
    ],
    'shape=hyperboloid&C=0,1,0&a=-0.5&r=1.5&E=3,2,1&d=-1,-0.25,-0.25',
  ),
  example(
    'hyperboloid-sphere',
    ['touching a sphere', 'named sphere', 't1 touches', 't1 ahead'],
    [
      ['a = −1 is a sphere of radius r,', 'a = -1', 'named sphere', 'distance r from C'],
      ['and the ray touches it: D = 0.', 't1 touches', 't1 ahead', 'D = 0'],
    ],
    'shape=hyperboloid&C=0,1,0&a=-1&r=1.5&E=4,1,1.5&d=-1,0,0&view=top',
  ),
];
