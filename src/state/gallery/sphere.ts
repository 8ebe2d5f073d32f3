import { type Example, example } from './define.ts';

export const SPHERE: readonly Example[] = [
  example(
    'sphere-hit',
    ['two points', 'class two'],
    [
      ['The ray enters and leaves;', 't1 enters', 't2 leaves', 't1 ahead'],
      ['A is |d|², which is never 0.', 'A > 0 for every d'],
    ],
    'shape=sphere&C=0,1,0&r=1.5&E=4,2,1&d=-1,-0.25,-0.25',
  ),
  example(
    'sphere-miss',
    ['a miss', 'class none', 'E outside'],
    [['D < 0: f is above zero for every t.', 'D < 0', 'f > 0 everywhere', 'class none']],
    'shape=sphere&C=0,1,0&r=1.5&E=3,1,2&d=-1,0,0&view=top',
  ),
  example(
    'sphere-tangent',
    ['tangent', 'class tangent'],
    [
      ['D = 0: the ray touches the sphere,', 'D = 0', 't1 touches', 'named sphere'],
      ['and there the normal is at a right angle to d.', 'N1 at a right angle to d'],
    ],
    'shape=sphere&C=0,1,0&r=1.5&E=4,2.5,0&d=-1,0,0&view=front',
  ),
  example(
    'sphere-inside',
    ['from inside', 'E inside'],
    [
      ['C < 0: E is inside,', 'C < 0', 'E inside'],
      ['so one root is behind E and one is ahead.', 't1 behind E', 't2 ahead'],
    ],
    'shape=sphere&C=0,1,0&r=1.5&E=0.5,1,0&d=-1,0.5,0.25',
  ),
  example(
    'sphere-far',
    ['from far away', 'E beyond 5e8'],
    [
      ['The ray has two points,', 'class two'],
      ['but the textbook formula says one double root.', 'textbook class tangent'],
    ],
    'shape=sphere&C=0,1,0&r=1.5&E=1000000000,1,0.5&d=-1,0,0&method=textbook',
  ),
];
