import {
  ball,
  material,
  PAPER,
  SAND,
  type ScenePreset,
  TEAL,
  table,
  VIOLET,
  WOOD,
} from './define.ts';

export const mirror2: ScenePreset = {
  id: 'mirror.2',
  reason: 'A mirror behind two shapes: what it shows is what another ray sees.',
  compare: 'off:reflection',
  scene: {
    title: 'a mirror',
    camera: { eye: [2.3, 2.9, 8], target: [0.05, 1.05, -0.4], angle: 32 },
    background: PAPER,
    ambient: 0.28,
    things: [
      table(3.8),
      {
        id: 'mirror',
        shape: { kind: 'square', corner: [-1.75, 0.14, -1.5], side: 3, axis: 'z' },
        material: material('#dfe3e6', { mirror: 0.9 }),
      },
      {
        id: 'frame',
        shape: { kind: 'square', corner: [-1.89, 0, -1.52], side: 3.28, axis: 'z' },
        material: material(WOOD),
      },
      ball('ball', [-1, 0.75, 0.35], 0.75, material(VIOLET)),
      {
        id: 'cone',
        shape: { kind: 'cone', vertex: [0.85, 1.9, 0], slope: 0.38 },
        material: material(SAND),
        between: [0, 1.9],
      },
      ball('small ball', [0.35, 0.32, 1.55], 0.32, material(TEAL)),
    ],
    lights: [{ light: 'point', id: 'lamp', colour: '#fffaf0', strength: 0.85, at: [-2.6, 5, 5.6] }],
  },
};
