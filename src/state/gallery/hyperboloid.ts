import type { Preset } from './define.ts';

export const HYPERBOLOID: readonly Preset[] = [
  {
    id: 'hyperboloid-hit',
    title: 'through the waist',
    look: 'The ray enters and leaves near the waist, where the radius is r.',
    link: '#/explore?shape=hyperboloid&C=0,1,0&a=0.4&r=1&E=3,1,1&d=-0.8,-0.2,-0.3',
    class: 'two',
  },
  {
    id: 'hyperboloid-miss',
    title: 'past the waist',
    look: 'Higher or lower it would hit; at the height of the waist the ray passes by.',
    link: '#/explore?shape=hyperboloid&C=0,1,0&a=0.5&r=1&E=3,1,1.5&d=-1,0,0',
    class: 'none',
  },
  {
    id: 'hyperboloid-out-in',
    title: 'out and in again',
    look: 'A < 0: the steep ray leaves through the waist and comes back in above it.',
    link: '#/explore?shape=hyperboloid&C=0,1,0&a=0.5&r=0.5&E=1.25,-1,0&d=-0.125,1,0',
    class: 'two',
  },
  {
    id: 'hyperboloid-parallel',
    title: 'parallel to the asymptote',
    look: 'A = 0: the ray runs along the asymptotic cone and meets the surface once.',
    link: '#/explore?shape=hyperboloid&C=0,1,0&a=1&r=1&E=3,3,0.5&d=-1,-1,0',
    class: 'one',
  },
  {
    id: 'hyperboloid-ruling',
    title: 'a line in the surface',
    look: 'This curved surface is full of straight lines, and the ray is one of them.',
    link: '#/explore?shape=hyperboloid&C=0,1,0&a=1&r=1&E=1,-1,-2&d=0,1,1',
    class: 'contained',
  },
  {
    id: 'hyperboloid-cylinder',
    title: 'a is 0',
    look: 'Slide a through 0: hyperboloid, cylinder, ellipsoid, and the formula does not notice.',
    link: '#/explore?shape=hyperboloid&C=0,1,0&a=0&r=1.5&E=3,2,1&d=-1,-0.25,-0.25',
    class: 'two',
  },
  {
    id: 'hyperboloid-ellipsoid',
    title: 'an ellipsoid',
    look: 'a < 0 closes the surface: A can no longer be 0, so the line has two points or one or none.',
    link: '#/explore?shape=hyperboloid&C=0,1,0&a=-0.5&r=1.5&E=3,2,1&d=-1,-0.25,-0.25',
    class: 'two',
  },
  {
    id: 'hyperboloid-sphere',
    title: 'touching a sphere',
    look: 'a = −1 is a sphere of radius r, and the ray touches it: D = 0.',
    link: '#/explore?shape=hyperboloid&C=0,1,0&a=-1&r=1.5&E=4,1,1.5&d=-1,0,0',
    class: 'tangent',
  },
];
