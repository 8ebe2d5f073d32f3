import { type Example, example } from './define.ts';

export const PARABOLOID: readonly Example[] = [
  example('paraboloid-hit', {
    title: ['two points', 'class two'],
    asks: ['Which way is the bowl open?', 'k > 0'],
    answer: [
      ['k > 0, and the bowl is open at the top:', 'k > 0'],
      ['the ray enters through its wall and leaves.', 't1 enters', 't2 leaves', 't1 ahead'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=paraboloid&V=0,0,0&k=2&E=4,2,1&d=-1,-0.125,-0.25',
  }),
  example('paraboloid-axis', {
    title: ['parallel to the axis', 'd along the axis', 'class one'],
    asks: ['What is left of f when d is parallel to the axis?', 'd along the axis', 'f straight'],
    answer: [
      ['A = 0:', 'A = 0'],
      ['f is a straight line', 'f straight'],
      ['and the ray meets the bowl once, at −C/B.', 'class one', 't1 = -C/B', 't1 ahead'],
    ],
    view: { azimuth: 20, elevation: 22, zoom: null },
    outside: [],
    link: 'shape=paraboloid&V=0,0,0&k=2&E=1,4,0.5&d=0,-1,0',
  }),
  example('paraboloid-tangent', {
    title: ['tangent', 'class tangent'],
    asks: ['At which angle does d meet N where D is zero?', 'D = 0', 'N1 at a right angle to d'],
    answer: [
      ['D = 0: the ray touches the bowl from outside,', 'D = 0', 't1 touches', 'E outside'],
      ['and there the normal is at a right angle to d.', 'N1 at a right angle to d'],
    ],
    view: { azimuth: 66, elevation: 29, zoom: null },
    outside: [],
    link: 'shape=paraboloid&V=0,0,0&k=2&E=4,2,2&d=-1,0,0',
  }),
  example('paraboloid-inside', {
    title: ['from inside', 'E inside'],
    asks: [
      'How many roots are ahead of E when it is inside the bowl?',
      'E inside',
      't1 behind E',
      't2 ahead',
    ],
    answer: [
      ['E is inside the bowl:', 'E inside', 'C < 0'],
      ['one root is behind E and one is ahead.', 't1 behind E', 't2 ahead'],
    ],
    view: { azimuth: 8, elevation: 22, zoom: null },
    outside: [],
    link: 'shape=paraboloid&V=0,0,0&k=2&E=0.5,2,0&d=-1,0.25,0.25',
  }),
  example('paraboloid-down', {
    title: ['turned over', 'k < 0'],
    asks: ['Which way does the surface go from V when k is negative?', 'k < 0', 'E below V'],
    answer: [
      ['k < 0, and the surface hangs down from V:', 'k < 0', 'E below V'],
      ['the ray enters and leaves.', 't1 enters', 't2 leaves', 't1 ahead'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=paraboloid&V=0,3,0&k=-1&E=3,1,1&d=-1,-0.125,-0.25',
  }),
];
