import { BLUE, ball, material, PAPER, SAND, type ScenePreset, table, VIOLET } from './define.ts';

export const shadows2: ScenePreset = {
  id: 'shadows.2',
  reason: 'Shadows and nothing else: one more ray for each point that faces the lamp.',
  compare: 'off:shadow',
  scene: {
    title: 'shadows only',
    camera: { eye: [1.4, 3.2, 8.6], target: [0.05, 0.6, 0.2], angle: 31 },
    background: PAPER,
    ambient: 0.28,
    things: [
      table(3.7),
      ball('ball', [-1.4, 0.9, 0.9], 0.9, material(VIOLET)),
      {
        id: 'disc',
        shape: { kind: 'circle', normal: [0.35, 1, 0.3], center: [0.45, 1.75, 1.1], radius: 0.72 },
        material: material(SAND),
      },
      {
        id: 'screen',
        shape: { kind: 'square', corner: [0.5, 0, -0.95], side: 2, axis: 'z' },
        material: material(BLUE),
      },
    ],
    lights: [
      { light: 'point', id: 'lamp', colour: '#fffaf0', strength: 0.8, at: [-3.4, 5.2, 5.4] },
    ],
  },
};
