import {
  BLUE,
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

export const shadows: ScenePreset = {
  id: 'shadows',
  reason: 'Shadows and nothing else: one more ray for each point that faces the lamp.',
  compare: 'off:shadow',
  scene: {
    title: 'shadows only',
    camera: CAMERA,
    background: PAPER,
    ambient: 0.25,
    things: [
      floor(STONE),
      ball('ball', [-1.6, 1.1, 0], 1.1, material(VIOLET)),
      {
        id: 'disc',
        shape: { kind: 'circle', normal: [0.3, 1, 0.2], center: [0.8, 2.2, 0.4], radius: 0.9 },
        material: material(SAND),
      },
      {
        id: 'screen',
        shape: { kind: 'square', corner: [1.2, 0, -1.6], side: 2, axis: 'z' },
        material: material(BLUE),
      },
    ],
    lights: [{ light: 'point', id: 'lamp', colour: '#ffffff', strength: 0.8, at: [-3, 6, 4] }],
  },
};
