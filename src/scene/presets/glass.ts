import {
  BLUE,
  ball,
  CAMERA,
  clear,
  floor,
  material,
  PAPER,
  SAND,
  type ScenePreset,
  STONE,
  VIOLET,
} from './define.ts';

export const glass: ScenePreset = {
  id: 'glass',
  reason: 'A ray goes into the ball at one root and out at the other: both are needed.',
  compare: 'off:refraction',
  scene: {
    title: 'glass',
    camera: CAMERA,
    background: PAPER,
    ambient: 0.25,
    things: [
      floor(STONE),
      ball('glass ball', [0, 1.3, 1], 1.3, material('#ffffff', { glass: clear(1.5) })),
      ball('left', [-2.2, 0.8, -2], 0.8, material(VIOLET)),
      ball('middle', [0.1, 0.8, -3], 0.8, material(BLUE)),
      ball('right', [2.2, 0.8, -2], 0.8, material(SAND)),
    ],
    lights: [{ light: 'point', id: 'lamp', colour: '#ffffff', strength: 0.8, at: [-3, 6, 5] }],
  },
};
