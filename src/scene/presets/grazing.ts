import { BLUE, material, SAND, type ScenePreset, VIOLET } from './define.ts';

export const grazing: ScenePreset = {
  id: 'grazing',
  reason:
    'Camera rays and light run along the surfaces: D is nearly 0, and a few wrong digits decide ' +
    'hit or miss.',
  compare: 'method:textbook',
  scene: {
    title: 'grazing rays',
    camera: { eye: [0, 1000.9, 300_000_000], target: [0, 1000, 0], angle: 0.0000012 },
    background: { low: '#d9dee4', high: '#f4f3ef' },
    ambient: 0.3,
    things: [
      {
        id: 'horizon',
        shape: { kind: 'hyperboloid', center: [0, 0, 0], flare: -1, radius: 1000 },
        material: material('#cfc8b9'),
      },
      {
        id: 'cone',
        shape: { kind: 'cone', vertex: [-1.4, 1002.2, 0], slope: 0.4 },
        material: material(VIOLET),
        between: [999.9, 1002.2],
      },
      {
        id: 'cylinder',
        shape: { kind: 'cylinder', center: [1.3, 0, 0], radius: 0.6 },
        material: material(BLUE),
        between: [999.9, 1001.6],
      },
      {
        id: 'saddle',
        shape: { kind: 'hyperboloid', center: [3.2, 1000.9, 0], flare: 0.4, radius: 0.4 },
        material: material(SAND),
        between: [999.9, 1001.9],
      },
    ],
    lights: [
      { light: 'sun', id: 'sun', colour: '#ffffff', strength: 0.8, towards: [-1, 0.06, 0.2] },
    ],
  },
};
