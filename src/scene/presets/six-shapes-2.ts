import {
  BLUE,
  DAYLIGHT,
  floor,
  GROUND,
  material,
  SAND,
  type ScenePreset,
  SKY,
  TEAL,
  VIOLET,
} from './define.ts';

export const sixShapes2: ScenePreset = {
  id: 'six-shapes.2',
  reason: 'The course’s six shapes, the round ones cut off at two heights; the floor is the plane.',
  compare: 'off:heights',
  scene: {
    title: 'six shapes',
    camera: { eye: [0.4, 3.3, 11], target: [0.1, 0.98, 0], angle: 26 },
    background: SKY,
    ambient: 0.3,
    things: [
      floor(GROUND),
      {
        id: 'cylinder',
        shape: { kind: 'cylinder', center: [2.55, 0, 0.4], radius: 0.72 },
        material: material(BLUE),
        between: [0, 1.7],
      },
      {
        id: 'cone',
        shape: { kind: 'cone', vertex: [-2.75, 2.25, 0.2], slope: 0.42 },
        material: material(VIOLET),
        between: [0, 2.25],
      },
      {
        id: 'hyperboloid',
        shape: { kind: 'hyperboloid', center: [0.75, 1.1, -0.4], flare: 0.42, radius: 0.44 },
        material: material(SAND),
        between: [0, 2.2],
      },
      {
        id: 'circle',
        shape: { kind: 'circle', normal: [0.4, 1, 0.7], center: [-0.65, 0.5, 1.9], radius: 0.6 },
        material: material(TEAL),
      },
      {
        id: 'square',
        shape: { kind: 'square', corner: [-1.75, 0, -1.5], side: 2, axis: 'z' },
        material: material('#b5766a'),
      },
    ],
    lights: [DAYLIGHT],
  },
};
