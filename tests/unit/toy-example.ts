import { type Example, example } from '../../src/state/gallery/define.ts';

/** Examples that are not Graze's own, as a newcomer would add them. */
export const OBLIQUE: readonly Example[] = [
  example('cylinder-through-axis', {
    title: ['through the middle', 't1 enters', 't2 leaves'],
    asks: ['What does f do while the ray is within the cylinder?', 'class two', 'f < 0 between'],
    answer: [
      ['Between its two roots', 'class two'],
      ['f is negative.', 'f < 0 between'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=cylinder&C=0,1,0&r=1.5&E=3.5,2,0&d=-1,-0.25,0',
  }),
];
