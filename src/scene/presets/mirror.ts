import {
  ball,
  CAMERA,
  floor,
  material,
  PAPER,
  SAND,
  type ScenePreset,
  STONE,
  VIOLET,
} from './define.ts';

export const mirror: ScenePreset = {
  id: 'mirror',
  reason: 'A mirror behind two shapes: what it shows is what another ray sees.',
  compare: 'off:reflection',
  scene: {
    title: 'a mirror',
    camera: CAMERA,
    background: PAPER,
    ambient: 0.25,
    things: [
      floor(STONE),
      {
        id: 'mirror',
        shape: { kind: 'square', corner: [-2.2, 0, -2], side: 4.4, axis: 'z' },
        material: material('#dfe3e6', { mirror: 0.9 }),
      },
      ball('ball', [-0.9, 0.9, 0], 0.9, material(VIOLET)),
      {
        id: 'cone',
        shape: { kind: 'cone', vertex: [1.2, 2.2, 0], slope: 0.4 },
        material: material(SAND),
        between: [0, 2.2],
      },
    ],
    lights: [{ light: 'point', id: 'lamp', colour: '#ffffff', strength: 0.8, at: [-3, 5, 5] }],
  },
};
