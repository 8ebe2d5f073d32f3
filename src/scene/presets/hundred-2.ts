import { DAYLIGHT, floor, GROUND, type ScenePreset, SKY } from './define.ts';
import { thing } from './hundred.ts';

export const hundred2: ScenePreset = {
  id: 'hundred.2',
  reason: 'A hundred shapes: boxes around boxes keep most questions from being asked.',
  compare: 'off:boxes',
  scene: {
    title: 'a hundred shapes',
    camera: { eye: [2.2, 7.6, 8], target: [0, 0, -4.3], angle: 36 },
    background: SKY,
    ambient: 0.3,
    things: [floor(GROUND), ...Array.from({ length: 100 }, (_, k) => thing(k))],
    lights: [DAYLIGHT],
  },
};
