import { type Example, example } from './define.ts';

export const HYPERBOLOID: readonly Example[] = [
  example('hyperboloid-hit', {
    title: ['through the waist', 'P1 within 0.5 of the waist', 'P2 within 0.5 of the waist'],
    asks: ['At which height is the radius r?', 'radius r at the waist'],
    answer: [
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
    view: { azimuth: 16, elevation: 10, zoom: null },
    outside: [],
    link: 'shape=hyperboloid&C=0,0.25,0&a=0.4&r=1&E=3,1,1&d=-0.8,-0.2,-0.3',
  }),
  example('hyperboloid-miss', {
    title: ['past the waist', 'class none', 'E outside', 'd level', 'E at the height of the waist'],
    asks: ['Would a ray hit at another height?', 'with E.y 3: class two', 'with E.y -1: class two'],
    answer: [
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
    view: { azimuth: 84, elevation: 8, zoom: null },
    outside: [],
    link: 'shape=hyperboloid&C=0,1,0&a=0.5&r=1&E=3,1,1.5&d=-1,0,0',
  }),
  example('hyperboloid-out-in', {
    title: ['out and in again', 't1 leaves', 't2 enters', 't1 ahead'],
    asks: ['Which way does the steep ray cross the wall first?', 'A < 0', 't1 leaves'],
    answer: [
      ['A < 0:', 'A < 0'],
      ['the steep ray leaves below the waist', 't1 ahead', 't1 leaves', 'P1 below the waist'],
      ['and comes back in above it.', 't2 enters', 'P2 above the waist'],
    ],
    view: { azimuth: 10, elevation: 8, zoom: null },
    outside: [],
    link: 'shape=hyperboloid&C=0,1,0&a=0.5&r=0.5&E=1.25,-1,0&d=-0.125,1,0',
  }),
  example('hyperboloid-parallel', {
    title: ['parallel to the asymptote', 'd along a generator', 'class one'],
    asks: ['Which direction gives a single root?', 'class one', 'd along a generator'],
    answer: [
      ['A = 0:', 'A = 0'],
      ['the ray is parallel to a line of the asymptotic cone', 'd along a generator'],
      ['and meets the surface once.', 'class one', 't1 ahead'],
    ],
    view: { azimuth: 16, elevation: 10, zoom: null },
    outside: [],
    link: 'shape=hyperboloid&C=0,1,0&a=1&r=1&E=3,3,0.5&d=-1,-1,0',
  }),
  example('hyperboloid-ruling', {
    title: ['a line in the surface', 'class contained'],
    asks: ['Can a whole line lie in a curved surface?', 'class contained'],
    answer: [
      ['This curved surface is full of straight lines,', 'ruled'],
      ['and the ray is one of them.', 'class contained'],
    ],
    view: { azimuth: 20, elevation: 22, zoom: null },
    outside: [],
    link: 'shape=hyperboloid&C=0,1,0&a=1&r=1&E=1,-1,-2&d=0,1,1',
  }),
  example('hyperboloid-cylinder', {
    title: ['a is 0', 'a = 0'],
    asks: [
      'What does the surface become when a goes through zero?',
      'with a 0.05: named hyperboloid',
      'named cylinder',
      'with a -0.05: named ellipsoid',
    ],
    answer: [
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
    view: 'iso',
    outside: [],
    link: 'shape=hyperboloid&C=0,1,0&a=0&r=1.5&E=3,2,1&d=-1,-0.25,-0.25',
  }),
  example('hyperboloid-ellipsoid', {
    title: ['an ellipsoid', 'named ellipsoid'],
    asks: ['Can A be zero when a is negative?', 'a < 0', 'A > 0 for every d'],
    answer: [
      ['a < 0 closes the surface:', 'a < 0', 'bounded'],
      ['A can no longer be 0, so a line has two points or one or none.', 'A > 0 for every d'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=hyperboloid&C=0,1,0&a=-0.5&r=1.5&E=3,2,1&d=-1,-0.25,-0.25',
  }),
  example('hyperboloid-sphere', {
    title: ['touching a sphere', 'named sphere', 't1 touches', 't1 ahead'],
    asks: ['Which surface is it when a = −1?', 'a = -1', 'named sphere'],
    answer: [
      ['a = −1 is a sphere of radius r,', 'a = -1', 'named sphere', 'distance r from C'],
      ['and the ray touches it: D = 0.', 't1 touches', 't1 ahead', 'D = 0'],
    ],
    view: 'top',
    outside: [],
    link: 'shape=hyperboloid&C=0,1,0&a=-1&r=1.5&E=4,1,1.5&d=-1,0,0',
  }),
];
