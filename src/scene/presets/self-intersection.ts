import { BLUE, ball, material, PAPER, SAND, type ScenePreset, STONE, VIOLET } from './define.ts';

export const selfIntersection: ScenePreset = {
  id: 'self-intersection',
  reason:
    'Three quadrics and a lamp: without a start rule a third of the pixels shade themselves, by ' +
    'the exact method too.',
  compare: 'start:none',
  scene: {
    title: 'three quadrics, one lamp',
    camera: { eye: [0.6, 3, 10], target: [0.2, 1, 0], angle: 34 },
    background: PAPER,
    ambient: 0.25,
    things: [
      ball('floor', [0, -1000, 0], 1000, material(STONE)),
      {
        id: 'cone',
        shape: { kind: 'cone', vertex: [-2.3, 2.7, 0.4], slope: 0.5 },
        material: material(VIOLET),
        between: [0, 2.7],
      },
      {
        id: 'hyperboloid',
        shape: { kind: 'hyperboloid', center: [0.4, 1.3, 0], flare: 0.35, radius: 0.5 },
        material: material(SAND),
        between: [0, 2.6],
      },
      {
        id: 'cylinder',
        shape: { kind: 'cylinder', center: [2.6, 0, 0], radius: 0.8 },
        material: material(BLUE),
        between: [0, 2],
      },
    ],
    lights: [{ light: 'point', id: 'lamp', colour: '#ffffff', strength: 0.8, at: [-5, 7, 6] }],
  },
};
