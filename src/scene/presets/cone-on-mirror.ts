import {
  ball,
  clear,
  GLINT,
  GLOSSY,
  material,
  PAPER,
  SAND,
  type ScenePreset,
  VIOLET,
} from './define.ts';

export const coneOnMirror: ScenePreset = {
  id: 'cone-on-mirror',
  reason: 'Take the mirror away, and the reflected rays and what they cost are gone.',
  compare: 'off:reflection',
  scene: {
    title: 'glass cone on a mirror',
    camera: { eye: [1.2, 3.2, 8], target: [0, 0.8, 0], angle: 34 },
    background: PAPER,
    ambient: 0.25,
    things: [
      {
        id: 'mirror',
        shape: { kind: 'circle', normal: [0, 1, 0], center: [0, 0, 0], radius: 3.2 },
        material: material('#cfd6da', { mirror: 0.8 }),
      },
      {
        id: 'glass cone',
        shape: { kind: 'cone', vertex: [0, 2.4, 0], slope: 0.5 },
        material: material('#ffffff', { glass: clear(1.5), shine: GLINT }),
        between: [0.02, 2.4],
        capped: true,
      },
      ball('ball', [-1.7, 0.6, -0.9], 0.6, material(VIOLET, { shine: GLOSSY })),
      ball('small ball', [1.7, 0.35, 0.6], 0.35, material(SAND, { shine: GLOSSY })),
    ],
    lights: [{ light: 'point', id: 'lamp', colour: '#ffffff', strength: 0.8, at: [-3, 6, 5] }],
  },
};
