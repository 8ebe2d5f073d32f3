import type { Preset } from './define.ts';

export const CYLINDER: readonly Preset[] = [
  {
    id: 'cylinder-hit',
    title: 'in and out',
    look: 'Two roots: the ray enters at t₁ and leaves at t₂, and f is negative in between.',
    link: '#/explore?shape=cylinder&C=0,1,0&r=1.5&E=4,2,1&d=-1,-0.25,-0.25',
    class: 'two',
  },
  {
    id: 'cylinder-miss',
    title: 'a miss',
    look: 'D < 0: the parabola stays above the axis, nearest where the ray is nearest to the cylinder.',
    link: '#/explore?shape=cylinder&C=0,1,0&r=1.5&E=4,1,2&d=-1,0,0',
    class: 'none',
  },
  {
    id: 'cylinder-tangent',
    title: 'tangent',
    look: 'D is exactly 0: one double root, and N stands at a right angle to d.',
    link: '#/explore?shape=cylinder&C=0,1,0&r=1.5&E=4,1,1.5&d=-1,0,0',
    class: 'tangent',
  },
  {
    id: 'cylinder-inside',
    title: 'from inside',
    look: 'C < 0 says that E is inside, so one root is behind E and the visible hit is t₂.',
    link: '#/explore?shape=cylinder&C=0,1,0&r=1.5&E=0.5,1,0&d=-1,0.25,0.5',
    class: 'two',
  },
  {
    id: 'cylinder-behind',
    title: 'both behind E',
    look: 'D > 0 and yet nothing is hit: both roots are negative.',
    link: '#/explore?shape=cylinder&C=0,1,0&r=1.5&E=3,1,0.5&d=1,0,0.25',
    class: 'two',
  },
  {
    id: 'cylinder-parallel',
    title: 'parallel to the axis',
    look: 'A = 0 and B = 0: f is constant, and dividing by 2A would be dividing by zero.',
    link: '#/explore?shape=cylinder&C=0,1,0&r=1.5&E=2.5,4,0&d=0,-1,0',
    class: 'none',
  },
  {
    id: 'cylinder-generator',
    title: 'along a generator',
    look: 'A, B and C are all 0: the whole line lies in the surface.',
    link: '#/explore?shape=cylinder&C=0,1,0&r=1.5&E=1.5,4,0&d=0,-1,0',
    class: 'contained',
  },
  {
    id: 'cylinder-axis',
    title: 'radius 0',
    look: 'Only the axis is left: a ray through it has a double root, and no normal there.',
    link: '#/explore?shape=cylinder&C=0,1,0&r=0&E=3,2,0&d=-1,-0.25,0',
    class: 'tangent',
  },
  {
    id: 'cylinder-far',
    title: 'from far away',
    look: 'E is 10⁸ away and the ray clearly hits, but the textbook formula says it misses: B² and 4AC agree in all their digits.',
    link: '#/explore?shape=cylinder&C=0,1,0&r=1&E=100000000,1,0.5&d=-1,0,0&method=textbook',
    class: 'two',
  },
  {
    id: 'cylinder-tiny',
    title: 'a tiny world',
    look: 'All lengths are about 10⁻⁹: an epsilon of 10⁻⁷ would call this a miss, or a hit at once.',
    link: '#/explore?shape=cylinder&C=0,0,0&r=1e-9&E=3e-9,1e-9,5e-10&d=-1,-0.25,0',
    class: 'two',
  },
];
