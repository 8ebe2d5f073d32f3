import { type Example, example } from './define.ts';

export const CONE: readonly Example[] = [
  example(
    'cone-hit',
    ['two points', 'class two'],
    [
      ['The ray crosses the lower nappe:', 'P1 below V', 'P2 below V', 't1 ahead'],
      ['it enters, then leaves.', 't1 enters', 't2 leaves'],
    ],
    'shape=cone&V=0,3,0&c=0.5&E=3,1,1&d=-0.75,-0.25,-0.25',
  ),
  example(
    'cone-miss',
    ['a miss', 'class none', 'E outside'],
    [
      [
        'At this height the cone is not as wide as the ray is off:',
        'd level',
        'line farther from the axis than the wall',
      ],
      ['D < 0.', 'D < 0'],
    ],
    'shape=cone&V=0,3,0&c=0.5&E=3,2,1.5&d=-1,0,0&view=ray',
  ),
  example(
    'cone-nappes',
    ['both nappes', 'P1 below V', 'P2 above V'],
    [
      ['A < 0:', 'A < 0'],
      ['the ray leaves the lower nappe', 't1 leaves', 'P1 below V', 't1 ahead'],
      ['and enters the upper one,', 't2 enters', 'P2 above V'],
      ['and the parabola opens downwards.', 'f opens downwards'],
    ],
    'shape=cone&V=0,3,0&c=0.5&E=1,0,0&d=-0.125,1,0.125',
  ),
  example(
    'cone-tangent',
    ['tangent', 'class tangent'],
    [
      ['D = 0 away from the vertex:', 'D = 0', 'P1 below V'],
      ['the ray touches the wall and goes on outside.', 't1 touches', 'f > 0 elsewhere'],
    ],
    'shape=cone&V=0,3,0&c=0.5&E=1,1,3&d=0,0,-1&view=ray',
  ),
  example(
    'cone-vertex',
    ['through the vertex', 'P1 at V'],
    [
      ['D = 0 here too,', 'D = 0'],
      [
        'but at the vertex the normal is zero: there is nothing to reflect about.',
        'P1 at V',
        'N1 is zero',
      ],
    ],
    'shape=cone&V=0,3,0&c=0.5&E=3,1,0&d=-0.75,0.5,0',
  ),
  example(
    'cone-parallel',
    ['parallel to a generator', 'd along a generator', 'class one'],
    [
      ['A = 0:', 'A = 0'],
      ['the parabola has become a straight line', 'f straight'],
      ['with a single root, −C/B.', 'class one', 't1 = -C/B'],
    ],
    'shape=cone&V=0,3,0&c=0.5&E=2.5,0,0&d=-0.5,1,0',
  ),
  example(
    'cone-generator',
    ['along a generator', 'd along a generator', 'class contained'],
    [
      ['The ray runs in the surface:', 'class contained'],
      ['A = B = C = 0,', 'A = 0', 'B = 0', 'C = 0'],
      [
        'through the vertex and up the other nappe.',
        'V ahead on the ray',
        'E below V',
        'd upwards',
      ],
    ],
    'shape=cone&V=0,3,0&c=0.5&E=1.5,0,0&d=-0.5,1,0',
  ),
  example(
    'cone-near-generator',
    ['almost along it', 'd within 1e-11 of a generator'],
    [
      ['A is about 10⁻¹², so the second root is very far out;', 'A about 1e-12', 't2 beyond 1e11'],
      [
        'the textbook formula loses digits of the near one: 3.75003 in place of 3.75000.',
        'textbook shows t1 3.75003',
        'exact shows t1 3.75000',
        'textbook t1: 5 digits right',
      ],
    ],
    'shape=cone&V=0,3,0&c=0.5&E=2.25,0,0&d=-0.500000000001,1,0&method=textbook',
  ),
  example(
    'cone-inside',
    ['from inside', 'E inside'],
    [
      ['E is inside the lower nappe:', 'E inside', 'E below V'],
      ['one root behind E, one ahead.', 't1 behind E', 't2 ahead'],
    ],
    'shape=cone&V=0,3,0&c=0.5&E=0.5,0,0&d=-1,0.125,0.25',
  ),
];
