import type { Preset } from './define.ts';

export const SQUARE: readonly Preset[] = [
  {
    id: 'square-hit',
    title: 'inside',
    look: 'Four comparisons decide: both coordinates in the plane lie between P and P + L.',
    link: '#/explore?shape=square&P=0,0,-1&L=2&axis=x&E=3,1,1&d=-0.8,-0.2,-0.3',
    class: 'one',
  },
  {
    id: 'square-edge',
    title: 'on an edge',
    look: 'y is exactly Py + L: the edge belongs to the square.',
    link: '#/explore?shape=square&P=0,0,-1&L=2&axis=x&E=3,2,0&d=-1,0,0',
    class: 'one',
  },
  {
    id: 'square-outside',
    title: 'past a corner',
    look: 'Beyond a corner the distance is measured to the corner, not to a side.',
    link: '#/explore?shape=square&P=0,0,-1&L=2&axis=x&E=3,2.75,2&d=-1,0,0',
    class: 'none',
  },
  {
    id: 'square-floor',
    title: 'lying down',
    look: 'With the normal along y the square is a floor, and x and z are compared.',
    link: '#/explore?shape=square&P=-1,0,-1&L=2&axis=y&E=3,2,1&d=-0.75,-0.5,-0.25',
    class: 'one',
  },
  {
    id: 'square-contained',
    title: 'in its plane',
    look: 'The ray lies in the plane and passes beside the square: still no single point.',
    link: '#/explore?shape=square&P=-1,0,-1&L=2&axis=y&E=3,0,2&d=-1,0,0',
    class: 'contained',
  },
];
