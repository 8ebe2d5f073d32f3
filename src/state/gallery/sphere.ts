import { type Example, example } from './define.ts';

export const SPHERE: readonly Example[] = [
  example('sphere-hit', {
    title: ['two points', 'class two'],
    asks: ['Is there a direction for which A is zero?', 'A > 0 for every d'],
    answer: [
      ['The ray enters and leaves;', 't1 enters', 't2 leaves', 't1 ahead'],
      ['A is |d|², which is never 0.', 'A > 0 for every d'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=sphere&C=0,1,0&r=1.5&E=4,2,1&d=-1,-0.25,-0.25',
  }),
  example('sphere-miss', {
    title: ['a miss', 'class none', 'E outside'],
    asks: ['Which sign has D when the ray passes by?', 'class none', 'D < 0'],
    answer: [['D < 0: f is above zero for every t.', 'D < 0', 'f > 0 everywhere', 'class none']],
    view: 'top',
    outside: [],
    link: 'shape=sphere&C=0,1,0&r=1.5&E=3,1,2&d=-1,0,0',
  }),
  example('sphere-tangent', {
    title: ['tangent', 'class tangent'],
    asks: [
      'At which angle does d meet N when there is one double root?',
      'class tangent',
      'N1 at a right angle to d',
    ],
    answer: [
      ['D = 0: the ray touches the sphere,', 'D = 0', 't1 touches', 'named sphere'],
      ['and there the normal is at a right angle to d.', 'N1 at a right angle to d'],
    ],
    view: 'front',
    outside: [],
    link: 'shape=sphere&C=0,1,0&r=1.5&E=4,2.5,0&d=-1,0,0',
  }),
  example('sphere-inside', {
    title: ['from inside', 'E inside'],
    asks: ['Where is E when C is negative?', 'C < 0', 'E inside'],
    answer: [
      ['C < 0: E is inside,', 'C < 0', 'E inside'],
      ['so one root is behind E and one is ahead.', 't1 behind E', 't2 ahead'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=sphere&C=0,1,0&r=1.5&E=0.5,1,0&d=-1,0.5,0.25',
  }),
  example('sphere-far', {
    title: ['from far away', 'E beyond 5e8'],
    asks: [
      'How many points are there, and how many does the textbook formula find?',
      'class two',
      'textbook class tangent',
    ],
    answer: [
      ['The ray has two points,', 'class two'],
      ['but the textbook formula says one double root.', 'textbook class tangent'],
    ],
    view: 'iso',
    outside: ['E'],
    link: 'shape=sphere&C=0,1,0&r=1.5&E=1000000000,1,0.5&d=-1,0,0&method=textbook',
  }),
];
