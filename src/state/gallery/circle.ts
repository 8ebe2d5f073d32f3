import type { Preset } from './define.ts';

export const CIRCLE: readonly Preset[] = [
  {
    id: 'circle-hit',
    title: 'inside',
    look: 'First the plane, then the question whether the point is within r of C.',
    link: '#/explore?shape=circle&N=1,0.5,0&C=0,1,0&r=2&E=3,1,1&d=-0.8,-0.2,-0.3',
    class: 'one',
  },
  {
    id: 'circle-rim',
    title: 'on the rim',
    look: '|P₁ − C| is exactly r: the rim belongs to the circle.',
    link: '#/explore?shape=circle&N=1,0,0&C=0,1,0&r=2&E=3,1,2&d=-1,0,0',
    class: 'one',
  },
  {
    id: 'circle-outside',
    title: 'beside it',
    look: 'The plane is met, but half a length outside the rim: no point.',
    link: '#/explore?shape=circle&N=1,0,0&C=0,1,0&r=2&E=3,1,2.5&d=-1,0,0',
    class: 'none',
  },
  {
    id: 'circle-contained',
    title: 'in its plane',
    look: 'Seen edge-on the circle is a line, and the ray runs along it.',
    link: '#/explore?shape=circle&N=1,0,0&C=0,1,0&r=2&E=0,1.5,4&d=0,0,-1',
    class: 'contained',
  },
];
