import { ball, CAMERA, material, PAPER, type ScenePreset, VIOLET } from './define.ts';

export const plain: ScenePreset = {
  id: 'plain',
  reason: 'One shape and one light: camera rays are all that it takes.',
  compare: 'on:shadow',
  scene: {
    title: 'one plain shape',
    camera: CAMERA,
    background: PAPER,
    ambient: 0.25,
    things: [ball('ball', [0, 1.2, 0], 1.6, material(VIOLET))],
    lights: [{ light: 'sun', id: 'sun', colour: '#ffffff', strength: 0.8, towards: [-1, 2, 2] }],
  },
};
