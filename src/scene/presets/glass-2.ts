import {
  BLUE,
  ball,
  clear,
  GLINT,
  material,
  PAPER,
  SAND,
  type ScenePreset,
  TEAL,
  table,
  VIOLET,
} from './define.ts';

export const glass2: ScenePreset = {
  id: 'glass.2',
  reason: 'A ray goes into the ball at one root and out at the other: both are needed.',
  compare: 'off:refraction',
  scene: {
    title: 'glass',
    camera: { eye: [0.9, 2.9, 8.6], target: [0.05, 0.95, 0], angle: 31 },
    background: PAPER,
    ambient: 0.28,
    things: [
      table(3.7),
      ball(
        'glass ball',
        [0, 1.25, 0.9],
        1.25,
        material('#ffffff', { glass: clear(1.5), shine: GLINT }),
      ),
      ball('left', [-1.65, 0.62, -1.9], 0.62, material(VIOLET)),
      ball('middle', [0.1, 0.62, -2.75], 0.62, material(TEAL)),
      ball('right', [1.85, 0.62, -1.9], 0.62, material(SAND)),
      ball('small ball', [1.75, 0.34, 1.3], 0.34, material(BLUE)),
    ],
    lights: [
      { light: 'point', id: 'lamp', colour: '#fffaf0', strength: 0.82, at: [-3.6, 5.6, 4.6] },
    ],
  },
};
