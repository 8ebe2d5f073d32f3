import { type Example, example } from './define.ts';

export const CYLINDER: readonly Example[] = [
  example(
    'cylinder-hit',
    ['in and out', 't1 enters', 't2 leaves'],
    [
      ['Two roots:', 'class two'],
      ['the ray enters at t₁ and leaves at t₂,', 't1 ahead', 't1 enters', 't2 leaves'],
      ['and f is negative in between.', 'f < 0 between'],
    ],
    'shape=cylinder&C=0,1,0&r=1.5&E=4,2,1&d=-1,-0.25,-0.25',
  ),
  example(
    'cylinder-miss',
    ['a miss', 'class none', 'E outside'],
    [
      ['D < 0:', 'D < 0'],
      ['the parabola stays above the t axis,', 'f > 0 everywhere'],
      ['lowest where the ray is nearest to the cylinder.', 'f lowest where nearest to the axis'],
    ],
    'shape=cylinder&C=0,1,0&r=1.5&E=4,1,2&d=-1,0,0&view=top',
  ),
  example(
    'cylinder-tangent',
    ['tangent', 'class tangent'],
    [
      ['D is exactly 0:', 'D = 0'],
      ['one double root,', 'class tangent'],
      ['and N stands at a right angle to d.', 'N1 at a right angle to d'],
    ],
    'shape=cylinder&C=0,1,0&r=1.5&E=4,1,1.5&d=-1,0,0&view=top',
  ),
  example(
    'cylinder-inside',
    ['from inside', 'E inside'],
    [
      ['C < 0 says that E is inside,', 'C < 0', 'E inside'],
      ['so one root is behind E', 't1 behind E'],
      ['and the visible hit is t₂.', 't2 ahead', 't2 leaves'],
    ],
    'shape=cylinder&C=0,1,0&r=1.5&E=0.5,1,0&d=-1,0.25,0.5',
  ),
  example(
    'cylinder-behind',
    ['both behind E', 't1 behind E', 't2 behind E'],
    [
      ['D > 0 and yet nothing is hit:', 'D > 0', 't2 behind E'],
      ['both roots are negative.', 't1 behind E', 't2 behind E'],
    ],
    'shape=cylinder&C=0,1,0&r=1.5&E=3,1,0.5&d=1,0,0.25',
  ),
  example(
    'cylinder-parallel',
    ['parallel to the axis', 'd along the axis', 'class none'],
    [
      ['A = 0 and B = 0:', 'A = 0', 'B = 0'],
      ['f is constant,', 'f constant'],
      ['and dividing by 2A would be dividing by zero.', 'A = 0'],
    ],
    'shape=cylinder&C=0,1,0&r=1.5&E=2.5,4,0&d=0,-1,0',
  ),
  example(
    'cylinder-generator',
    ['along a generator', 'd along the axis', 'class contained'],
    [
      ['A, B and C are all 0:', 'A = 0', 'B = 0', 'C = 0'],
      ['the whole line lies in the surface.', 'class contained'],
    ],
    'shape=cylinder&C=0,1,0&r=1.5&E=1.5,4,0&d=0,-1,0',
  ),
  example(
    'cylinder-axis',
    ['radius 0', 'r = 0'],
    [
      ['Only the axis is left:', 'named axis'],
      ['a ray through it has a double root, and no normal there.', 'class tangent', 'N1 is zero'],
    ],
    'shape=cylinder&C=0,1,0&r=0&E=3,2,0&d=-1,-0.25,0',
  ),
  example(
    'cylinder-far',
    ['from far away', 'E beyond 1e8'],
    [
      [
        'E is more than 10⁸ away and the ray crosses the axis,',
        'E beyond 1e8',
        'class two',
        'axis missed by < 1e-7',
      ],
      ['but the textbook formula says that it misses:', 'textbook class none', 'textbook D < 0'],
      ['B² and 4AC differ by less than the last digit of either.', 'D below the last digit of B²'],
    ],
    'shape=cylinder&C=0,1,0&r=1&E=100000000,1,50000000&d=-0.2,0,-0.1&method=textbook',
  ),
  example(
    'cylinder-tiny',
    ['a tiny world', 'lengths about 1e-9'],
    [
      ['E, r and both roots are about 10⁻⁹:', 'lengths about 1e-9', 'roots about 1e-9'],
      [
        'a program that takes only t > 10⁻⁷ as ahead of E finds no hit at all.',
        'no root above 1e-7',
        't1 ahead',
      ],
    ],
    'shape=cylinder&C=0,0,0&r=1e-9&E=3e-9,1e-9,5e-10&d=-1,-0.25,0',
  ),
];
