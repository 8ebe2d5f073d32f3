import type { Preset } from './define.ts';

export const PLANE: readonly Preset[] = [
  {
    id: 'plane-hit',
    title: 'one point',
    look: 'N·d is not zero, so the line meets the plane once: f(t) is a straight line.',
    link: '#/explore?shape=plane&N=0,1,0&P=0,0,0&E=3,3,1&d=-1,-1,0',
    class: 'one',
  },
  {
    id: 'plane-behind',
    title: 'behind E',
    look: 'The root is −2: the line meets the plane, the ray does not.',
    link: '#/explore?shape=plane&N=0,1,0&P=0,0,0&E=2,2,1&d=-1,1,0',
    class: 'one',
  },
  {
    id: 'plane-parallel',
    title: 'parallel',
    look: 'N·d = 0 and E is off the plane: f(t) is constant and never zero.',
    link: '#/explore?shape=plane&N=0,1,0&P=0,0,0&E=3,1,1&d=-1,0,0',
    class: 'none',
  },
  {
    id: 'plane-contained',
    title: 'in the plane',
    look: 'N·d = 0 and N·(E − P) = 0: every t is a root, so no single one is the answer.',
    link: '#/explore?shape=plane&N=0,1,0&P=0,0,0&E=3,0,1&d=-1,0,0.25',
    class: 'contained',
  },
  {
    id: 'plane-grazing',
    title: 'at a flat angle',
    look: 'N·d is small: the smallest change of d moves the point far along the plane.',
    link: '#/explore?shape=plane&N=0,1,0&P=0,0,0&E=3,0.125,1&d=-1,-0.03125,0',
    class: 'one',
  },
];
