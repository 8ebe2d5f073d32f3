import { type Example, example } from './define.ts';

export const CYLINDER: readonly Example[] = [
  example('cylinder-hit', {
    title: ['in and out', 't1 enters', 't2 leaves'],
    asks: ['Which sign has f between the roots?', 'class two', 'f < 0 between'],
    answer: [
      ['Two roots:', 'class two'],
      ['the ray enters at t₁ and leaves at t₂,', 't1 ahead', 't1 enters', 't2 leaves'],
      ['and f is negative in between.', 'f < 0 between'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=cylinder&C=0,1,0&r=1.5&E=4,2,1&d=-1,-0.25,-0.25',
  }),
  example('cylinder-miss', {
    title: ['a miss', 'class none', 'E outside'],
    asks: [
      'Where is f lowest when the ray passes by?',
      'class none',
      'f lowest where nearest to the axis',
    ],
    answer: [
      ['D < 0:', 'D < 0'],
      ['the parabola stays above the t axis,', 'f > 0 everywhere'],
      ['lowest where the ray is nearest to the cylinder.', 'f lowest where nearest to the axis'],
    ],
    view: 'top',
    outside: [],
    link: 'shape=cylinder&C=0,1,0&r=1.5&E=4,1,2&d=-1,0,0',
  }),
  example('cylinder-tangent', {
    title: ['tangent', 'class tangent'],
    asks: [
      'At which angle does d meet N when both roots are the same?',
      'class tangent',
      'N1 at a right angle to d',
    ],
    answer: [
      ['D is exactly 0:', 'D = 0'],
      ['one double root,', 'class tangent'],
      ['and N stands at a right angle to d.', 'N1 at a right angle to d'],
    ],
    view: 'top',
    outside: [],
    link: 'shape=cylinder&C=0,1,0&r=1.5&E=4,1,1.5&d=-1,0,0',
  }),
  example('cylinder-inside', {
    title: ['from inside', 'E inside'],
    asks: ['Where is E when C is negative?', 'C < 0', 'E inside'],
    answer: [
      ['C < 0 says that E is inside,', 'C < 0', 'E inside'],
      ['so one root is behind E', 't1 behind E'],
      ['and the visible hit is t₂.', 't2 ahead', 't2 leaves'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=cylinder&C=0,1,0&r=1.5&E=0.5,1,0&d=-1,0.25,0.5',
  }),
  example('cylinder-behind', {
    title: ['both behind E', 't1 behind E', 't2 behind E'],
    asks: ['D is positive: why does the ray meet nothing?', 'D > 0', 't1 behind E', 't2 behind E'],
    answer: [
      ['D > 0 and yet nothing is hit:', 'D > 0', 't2 behind E'],
      ['both roots are negative.', 't1 behind E', 't2 behind E'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=cylinder&C=0,1,0&r=1.5&E=3,1,0.5&d=1,0,0.25',
  }),
  example('cylinder-parallel', {
    title: ['parallel to the axis', 'd along the axis', 'class none'],
    asks: ['Why has f no turning point at −B/2A here?', 'A = 0', 'f constant'],
    answer: [
      ['A = 0 and B = 0:', 'A = 0', 'B = 0'],
      ['f is constant,', 'f constant'],
      ['and dividing by 2A would be dividing by zero.', 'A = 0'],
    ],
    view: { azimuth: 16, elevation: 10, zoom: null },
    outside: [],
    link: 'shape=cylinder&C=0,1,0&r=1.5&E=2.5,4,0&d=0,-1,0',
  }),
  example('cylinder-generator', {
    title: ['along a generator', 'd along the axis', 'class contained'],
    asks: ['Which t are roots when A, B and C are all zero?', 'A = 0', 'B = 0', 'C = 0'],
    answer: [
      ['A, B and C are all 0:', 'A = 0', 'B = 0', 'C = 0'],
      ['the whole line lies in the surface.', 'class contained'],
    ],
    view: { azimuth: 30, elevation: 10, zoom: null },
    outside: [],
    link: 'shape=cylinder&C=0,1,0&r=1.5&E=1.5,4,0&d=0,-1,0',
  }),
  example('cylinder-axis', {
    title: ['radius 0', 'r = 0'],
    asks: ['What is left of a cylinder of radius 0?', 'r = 0', 'named axis'],
    answer: [
      ['Only the axis is left:', 'named axis'],
      ['a ray through it has a double root, and no normal there.', 'class tangent', 'N1 is zero'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=cylinder&C=0,1,0&r=0&E=3,2,0&d=-1,-0.25,0',
  }),
  example('cylinder-far', {
    title: ['from far away', 'E beyond 1e8'],
    asks: ['Does the ray miss, as the textbook formula says?', 'textbook class none', 'class two'],
    answer: [
      [
        'E is more than 10⁸ away and the ray crosses the axis,',
        'E beyond 1e8',
        'class two',
        'axis missed by < 1e-7',
      ],
      ['but the textbook formula says that it misses:', 'textbook class none', 'textbook D < 0'],
      ['B² and 4AC differ by less than the last digit of either.', 'D below the last digit of B²'],
    ],
    view: 'iso',
    outside: ['E'],
    link: 'shape=cylinder&C=0,1,0&r=1&E=100000000,1,50000000&d=-0.2,0,-0.1&method=textbook',
  }),
  example('cylinder-tiny', {
    title: ['a tiny world', 'lengths about 1e-9'],
    asks: ['Does a program that wants t > 10⁻⁷ find a hit?', 'no root above 1e-7', 't1 ahead'],
    answer: [
      ['E, r and both roots are about 10⁻⁹:', 'lengths about 1e-9', 'roots about 1e-9'],
      [
        'a program that takes only t > 10⁻⁷ as ahead of E finds no hit at all.',
        'no root above 1e-7',
        't1 ahead',
      ],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=cylinder&C=0,0,0&r=1e-9&E=3e-9,1e-9,5e-10&d=-1,-0.25,0',
  }),
];
