import {
  BLUE,
  floor,
  material,
  PAPER,
  SAND,
  type ScenePreset,
  STONE,
  TEAL,
  VIOLET,
} from './define.ts';

export const sixShapes: ScenePreset = {
  id: 'six-shapes',
  reason: 'The course’s six shapes, the round ones cut off at two heights.',
  compare: 'off:heights',
  scene: {
    title: 'six shapes',
    camera: { eye: [0, 3.4, 11], target: [0, 1, 0], angle: 34 },
    background: PAPER,
    ambient: 0.25,
    things: [
      floor(STONE),
      {
        id: 'cylinder',
        shape: { kind: 'cylinder', center: [2.3, 0, 0.5], radius: 0.75 },
        material: material(BLUE),
        between: [0, 1.9],
      },
      {
        id: 'cone',
        shape: { kind: 'cone', vertex: [-2.6, 2.4, 0.5], slope: 0.45 },
        material: material(VIOLET),
        between: [0, 2.4],
      },
      {
        id: 'hyperboloid',
        shape: { kind: 'hyperboloid', center: [0, 1.2, 0], flare: 0.45, radius: 0.5 },
        material: material(SAND),
        between: [0, 2.4],
      },
      {
        id: 'circle',
        shape: { kind: 'circle', normal: [0.4, 1, 0.5], center: [-1.2, 0.6, 2.4], radius: 0.55 },
        material: material(TEAL),
      },
      {
        id: 'square',
        shape: { kind: 'square', corner: [-1.5, 0, -3], side: 3, axis: 'z' },
        material: material('#a9685c'),
      },
    ],
    lights: [{ light: 'point', id: 'lamp', colour: '#ffffff', strength: 0.8, at: [-4, 7, 6] }],
  },
};
