import { BLUE, ball, material, SAND, type ScenePreset, STONE, TEAL, VIOLET } from './define.ts';

/** Unit of length of the small things. */
const U = 1e-5;

export const twoScales: ScenePreset = {
  id: 'two-scales',
  reason:
    'Things of a hundred-thousandth before hills of thousands of millions: an epsilon that cures ' +
    'the hills swallows the little shadows.',
  compare: 'start:0.001',
  scene: {
    title: 'two scales',
    camera: { eye: [1 * U, 3 * U, 9 * U], target: [0, 1.2 * U, 0], angle: 34 },
    background: { low: '#d9dee4', high: '#f4f3ef' },
    ambient: 0.25,
    things: [
      {
        id: 'table',
        shape: { kind: 'circle', normal: [0, 1, 0], center: [0, 0, 0], radius: 3.2 * U },
        material: material(STONE),
      },
      {
        id: 'cone',
        shape: { kind: 'cone', vertex: [-1.3 * U, 2 * U, 0], slope: 0.4 },
        material: material(VIOLET),
        between: [0, 2 * U],
      },
      {
        id: 'cylinder',
        shape: { kind: 'cylinder', center: [1.2 * U, 0, 0.3 * U], radius: 0.6 * U },
        material: material(BLUE),
        between: [0, 1.4 * U],
      },
      ball('left hill', [-3e9, -3e9, -9e9], 3.4e9, material(TEAL)),
      ball('right hill', [3.5e9, -4e9, -1.1e10], 5e9, material(SAND)),
    ],
    lights: [
      { light: 'sun', id: 'sun', colour: '#ffffff', strength: 0.8, towards: [-2, 2.2, 1.6] },
    ],
  },
};
