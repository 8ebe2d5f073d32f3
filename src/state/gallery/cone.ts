import { type Example, example } from './define.ts';

export const CONE: readonly Example[] = [
  example('cone-hit', {
    title: ['two points', 'class two'],
    asks: ['Which nappe does the ray cross?', 'P1 below V', 'P2 below V'],
    answer: [
      ['The ray crosses the lower nappe:', 'P1 below V', 'P2 below V', 't1 ahead'],
      ['it enters, then leaves.', 't1 enters', 't2 leaves'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=cone&V=0,3,0&c=0.5&E=3,1,1&d=-0.75,-0.25,-0.25',
  }),
  example('cone-miss', {
    title: ['a miss', 'class none', 'E outside'],
    asks: [
      'How wide is the cone at the height of the ray?',
      'd level',
      'line farther from the axis than the wall',
    ],
    answer: [
      [
        'At this height the cone is not as wide as the ray is off:',
        'd level',
        'line farther from the axis than the wall',
      ],
      ['D < 0.', 'D < 0'],
    ],
    view: { azimuth: 84, elevation: 8, zoom: null },
    outside: [],
    link: 'shape=cone&V=0,3,0&c=0.5&E=3,2,1.5&d=-1,0,0',
  }),
  example('cone-nappes', {
    title: ['both nappes', 'P1 below V', 'P2 above V'],
    asks: ['Which sign has A when the ray meets both nappes?', 'A < 0', 'P1 below V', 'P2 above V'],
    answer: [
      ['A < 0:', 'A < 0'],
      ['the ray leaves the lower nappe', 't1 leaves', 'P1 below V', 't1 ahead'],
      ['and enters the upper one,', 't2 enters', 'P2 above V'],
      ['and the parabola opens downwards.', 'f opens downwards'],
    ],
    view: { azimuth: 30, elevation: 8, zoom: null },
    outside: [],
    link: 'shape=cone&V=0,3,0&c=0.5&E=1,0,0&d=-0.125,1,0.125',
  }),
  example('cone-tangent', {
    title: ['tangent', 'class tangent'],
    asks: [
      'What is D when the ray stays outside and yet has a point?',
      'class tangent',
      'f > 0 elsewhere',
    ],
    answer: [
      ['D = 0 away from the vertex:', 'D = 0', 'P1 below V'],
      ['the ray touches the wall and goes on outside.', 't1 touches', 'f > 0 elsewhere'],
    ],
    view: { azimuth: -6, elevation: 19, zoom: null },
    outside: [],
    link: 'shape=cone&V=0,3,0&c=0.5&E=1,1,3&d=0,0,-1',
  }),
  example('cone-vertex', {
    title: ['through the vertex', 'P1 at V'],
    asks: ['Where does the normal point when the ray goes through V?', 'P1 at V'],
    answer: [
      ['D = 0 here too,', 'D = 0'],
      [
        'but at the vertex the normal is zero: there is nothing to reflect about.',
        'P1 at V',
        'N1 is zero',
      ],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=cone&V=0,3,0&c=0.5&E=3,1,0&d=-0.75,0.5,0',
  }),
  example('cone-parallel', {
    title: ['parallel to a generator', 'd along a generator', 'class one'],
    asks: [
      'How many roots are left when d is parallel to a generator?',
      'd along a generator',
      'class one',
    ],
    answer: [
      ['A = 0:', 'A = 0'],
      ['the parabola has become a straight line', 'f straight'],
      ['with a single root, −C/B.', 'class one', 't1 = -C/B'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=cone&V=0,3,0&c=0.5&E=2.5,0,0&d=-0.5,1,0',
  }),
  example('cone-generator', {
    title: ['along a generator', 'd along a generator', 'class contained'],
    asks: [
      'What are A, B and C when the ray is a generator?',
      'd along a generator',
      'class contained',
    ],
    answer: [
      ['The ray runs in the surface:', 'class contained'],
      ['A = B = C = 0,', 'A = 0', 'B = 0', 'C = 0'],
      [
        'through the vertex and up the other nappe.',
        'V ahead on the ray',
        'E below V',
        'd upwards',
      ],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=cone&V=0,3,0&c=0.5&E=1.5,0,0&d=-0.5,1,0',
  }),
  example('cone-near-generator', {
    title: ['almost along it', 'd within 1e-11 of a generator'],
    asks: [
      'What does the textbook formula make of t₁ when A is almost zero?',
      'A about 1e-12',
      'textbook t1: 5 digits right',
    ],
    answer: [
      ['A is about 10⁻¹², so the second root is very far out;', 'A about 1e-12', 't2 beyond 1e11'],
      [
        'the textbook formula loses digits of the near one: 3.75003 in place of 3.75000.',
        'textbook shows t1 3.75003',
        'exact shows t1 3.75000',
        'textbook t1: 5 digits right',
      ],
    ],
    view: 'iso',
    outside: ['P2'],
    link: 'shape=cone&V=0,3,0&c=0.5&E=2.25,0,0&d=-0.500000000001,1,0&method=textbook',
  }),
  example('cone-inside', {
    title: ['from inside', 'E inside'],
    asks: ['Which of the two roots is ahead of E?', 'class two', 'E inside', 't2 ahead'],
    answer: [
      ['E is inside the lower nappe:', 'E inside', 'E below V'],
      ['one root behind E, one ahead.', 't1 behind E', 't2 ahead'],
    ],
    view: 'iso',
    outside: [],
    link: 'shape=cone&V=0,3,0&c=0.5&E=0.5,0,0&d=-1,0.125,0.25',
  }),
];
