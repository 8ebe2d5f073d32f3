import { BLUE, ball, material, SAND, type ScenePreset, VIOLET } from './define.ts';

export const far: ScenePreset = {
  id: 'far',
  reason:
    'A camera a hundred million lengths away, and light that grazes: what the digits are for. ' +
    'float32 sees what is not there, the textbook loses the silhouettes.',
  compare: 'method:textbook32',
  scene: {
    title: 'seen from very far',
    camera: { eye: [0, 20_000_000, 100_000_000], target: [0, 1, 0], angle: 0.000003 },
    background: { low: '#d9dee4', high: '#f4f3ef' },
    ambient: 0.2,
    things: [
      {
        id: 'floor',
        shape: { kind: 'circle', normal: [0, 1, 0], center: [0, 0, 0], radius: 4.5 },
        material: material('#d6d0c4'),
      },
      ball('ball', [0, 1, 0.6], 1, material(VIOLET)),
      {
        id: 'cylinder',
        shape: { kind: 'cylinder', center: [-2.3, 0, 0], radius: 0.7 },
        material: material(BLUE),
        between: [0, 1.8],
      },
      {
        id: 'cone',
        shape: { kind: 'cone', vertex: [2.3, 2, 0], slope: 0.45 },
        material: material(SAND),
        between: [0, 2],
      },
    ],
    lights: [
      { light: 'sun', id: 'sun', colour: '#ffffff', strength: 0.9, towards: [-1, 0.35, 0.6] },
    ],
  },
};
