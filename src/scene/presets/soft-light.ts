import {
  BLUE,
  ball,
  CAMERA,
  floor,
  material,
  PAPER,
  type ScenePreset,
  STONE,
  VIOLET,
} from './define.ts';

export const softLight: ScenePreset = {
  id: 'soft-light',
  reason: 'A lamp with a size: many rays to it, and the share that arrives is the light.',
  compare: 'off:soft-shadow',
  scene: {
    title: 'a soft light',
    camera: CAMERA,
    background: PAPER,
    ambient: 0.25,
    things: [
      floor(STONE),
      ball('ball', [-1.2, 1.1, 0], 1.1, material(VIOLET)),
      {
        id: 'screen',
        shape: { kind: 'square', corner: [0.8, 0, -1], side: 2, axis: 'z' },
        material: material(BLUE),
      },
    ],
    lights: [
      {
        light: 'sphere',
        id: 'globe',
        colour: '#fffaf0',
        strength: 0.85,
        at: [-3, 5, 4],
        radius: 1.2,
      },
    ],
  },
};
