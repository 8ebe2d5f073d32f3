import { ball, floor, material, PAPER, type ScenePreset, STONE, TEAL } from './define.ts';

export const facingMirrors: ScenePreset = {
  id: 'facing-mirrors',
  reason: 'Two mirrors face each other: each ray goes on until it can no longer change its pixel.',
  compare: 'off:reflection',
  scene: {
    title: 'mirrors that face each other',
    camera: { eye: [1.1, 1.7, 2.3], target: [0, 1.2, -3], angle: 62 },
    background: PAPER,
    ambient: 0.25,
    things: [
      floor(STONE),
      {
        id: 'near mirror',
        shape: { kind: 'square', corner: [-5, 0, 3], side: 10, axis: 'z' },
        material: material('#c9d2d6', { mirror: 0.85 }),
      },
      {
        id: 'far mirror',
        shape: { kind: 'square', corner: [-5, 0, -3], side: 10, axis: 'z' },
        material: material('#c9d2d6', { mirror: 0.85 }),
      },
      ball('ball', [-0.8, 0.8, -0.6], 0.8, material(TEAL)),
    ],
    lights: [{ light: 'point', id: 'lamp', colour: '#ffffff', strength: 0.8, at: [1, 6, 1] }],
  },
};
