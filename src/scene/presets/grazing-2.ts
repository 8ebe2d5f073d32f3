import { BLUE, material, SAND, type ScenePreset, TEAL, VIOLET } from './define.ts';

/** Radius of the small world. */
const R = 16;

export const grazing2: ScenePreset = {
  id: 'grazing.2',
  reason:
    'The sun sets on a small world, seen from three hundred million lengths away: rays and light ' +
    'run along the ground, and a few wrong digits decide hit or miss.',
  compare: 'method:textbook',
  scene: {
    title: 'sunset on a small world',
    camera: {
      eye: [0, R + 60_000_000, 300_000_000],
      target: [0.25, R + 0.05, 0],
      angle: 0.0000011,
    },
    background: { low: '#e9c9a6', high: '#f6e6cf' },
    ambient: 0.2,
    things: [
      {
        id: 'world',
        shape: { kind: 'sphere', center: [0, 0, 0], radius: R },
        material: material('#dccfb6'),
      },
      {
        id: 'cone',
        shape: { kind: 'cone', vertex: [-2.7, R + 1.35, 0.2], slope: 0.4 },
        material: material(VIOLET),
        between: [R - 0.55, R + 1.35],
      },
      {
        id: 'tower',
        shape: { kind: 'cylinder', center: [-0.45, 0, -0.1], radius: 0.42 },
        material: material(BLUE),
        between: [R - 0.3, R + 1.5],
      },
      {
        id: 'saddle',
        shape: { kind: 'hyperboloid', center: [1.55, R + 0.55, 0.1], flare: 0.4, radius: 0.3 },
        material: material(SAND),
        between: [R - 0.4, R + 1.3],
      },
      {
        id: 'far tower',
        shape: { kind: 'cylinder', center: [3.5, 0, -0.3], radius: 0.3 },
        material: material(TEAL),
        between: [R - 0.7, R + 0.95],
      },
    ],
    lights: [
      { light: 'sun', id: 'sun', colour: '#ffd9a6', strength: 0.95, towards: [-1, 0.075, 0.42] },
    ],
  },
};
