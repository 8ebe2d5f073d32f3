import {
  CAMERA,
  floor,
  material,
  PAPER,
  type ScenePreset,
  STONE,
  VIOLET,
} from '../../src/scene/presets/define.ts';

/** A scene that is not Graze's own, as a newcomer would add it. */
export const column: ScenePreset = {
  id: 'column',
  reason: 'A column on a floor, and its shadow.',
  scene: {
    title: 'a column',
    camera: CAMERA,
    background: PAPER,
    ambient: 0.3,
    things: [
      floor(STONE),
      {
        id: 'column',
        shape: { kind: 'cylinder', center: [0, 0, 0], radius: 0.5 },
        material: material(VIOLET),
        between: [0, 2],
        capped: true,
      },
    ],
    lights: [{ light: 'point', id: 'lamp', colour: '#ffffff', strength: 0.7, at: [-3, 5, 5] }],
  },
};
