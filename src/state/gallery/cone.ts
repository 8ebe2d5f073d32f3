import type { Preset } from './define.ts';

export const CONE: readonly Preset[] = [
  {
    id: 'cone-hit',
    title: 'two points',
    look: 'The ray crosses the lower nappe: it enters, then leaves.',
    link: '#/explore?shape=cone&V=0,3,0&c=0.5&E=3,1,1&d=-0.8,-0.2,-0.3',
    class: 'two',
  },
  {
    id: 'cone-miss',
    title: 'a miss',
    look: 'At this height the cone is not as wide as the ray is off: D < 0.',
    link: '#/explore?shape=cone&V=0,3,0&c=0.5&E=3,2,1.5&d=-1,0,0',
    class: 'none',
  },
  {
    id: 'cone-nappes',
    title: 'both nappes',
    look: 'A < 0: the ray leaves the lower nappe and enters the upper one, and the parabola opens downwards.',
    link: '#/explore?shape=cone&V=0,3,0&c=0.5&E=1,0,0&d=-0.125,1,0.125',
    class: 'two',
  },
  {
    id: 'cone-tangent',
    title: 'tangent',
    look: 'D = 0 away from the vertex: the ray touches the wall and goes on outside.',
    link: '#/explore?shape=cone&V=0,3,0&c=0.5&E=1,1,3&d=0,0,-1',
    class: 'tangent',
  },
  {
    id: 'cone-vertex',
    title: 'through the vertex',
    look: 'D = 0 here too, but at the vertex the normal is zero: there is no side to reflect from.',
    link: '#/explore?shape=cone&V=0,3,0&c=0.5&E=3,1,0&d=-0.75,0.5,0',
    class: 'tangent',
  },
  {
    id: 'cone-parallel',
    title: 'parallel to a generator',
    look: 'A = 0: the parabola has become a straight line with a single root, −C/B.',
    link: '#/explore?shape=cone&V=0,3,0&c=0.5&E=2.5,0,0&d=-0.5,1,0',
    class: 'one',
  },
  {
    id: 'cone-generator',
    title: 'along a generator',
    look: 'The ray runs inside the wall: A = B = C = 0, through the vertex and up the other nappe.',
    link: '#/explore?shape=cone&V=0,3,0&c=0.5&E=1.5,0,0&d=-0.5,1,0',
    class: 'contained',
  },
  {
    id: 'cone-near-generator',
    title: 'almost along it',
    look: 'A is about 10⁻⁹, so the second root is very far out; with the textbook formula the near one loses digits.',
    link: '#/explore?shape=cone&V=0,3,0&c=0.5&E=2.5,0,0&d=-0.500000001,1,0&method=textbook',
    class: 'two',
  },
  {
    id: 'cone-inside',
    title: 'from inside',
    look: 'E is inside the lower nappe: one root behind E, one ahead.',
    link: '#/explore?shape=cone&V=0,3,0&c=0.5&E=0.5,0,0&d=-1,0.125,0.25',
    class: 'two',
  },
];
