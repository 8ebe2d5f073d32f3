import { BLUE, ball, material, PAPER, SAND, type ScenePreset, table, VIOLET } from './define.ts';

export const softLight2: ScenePreset = {
  id: 'soft-light.2',
  reason: 'A lamp with a size: many rays to it, and the share that arrives is the light.',
  compare: 'off:soft-shadow',
  scene: {
    title: 'a soft light',
    camera: { eye: [1.2, 3.4, 8.4], target: [0.25, 0.75, 0], angle: 33 },
    background: PAPER,
    ambient: 0.26,
    things: [
      table(3.9),
      ball('ball', [-1.5, 0.85, 0.3], 0.85, material(VIOLET)),
      {
        id: 'column',
        shape: { kind: 'cylinder', center: [0.35, 0, -0.7], radius: 0.26 },
        material: material(SAND),
        between: [0, 2.2],
        capped: true,
      },
      {
        id: 'screen',
        shape: { kind: 'square', corner: [1.05, 0, 0.2], side: 1.25, axis: 'z' },
        material: material(BLUE),
      },
    ],
    lights: [
      {
        light: 'sphere',
        id: 'globe',
        colour: '#fff4e2',
        strength: 0.85,
        at: [-4, 4.8, 3.6],
        radius: 1.1,
      },
    ],
  },
};
