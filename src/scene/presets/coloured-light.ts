import { ball, floor, material, PAPER, type ScenePreset, STONE } from './define.ts';

const leaf = { index: 1.5, absorption: [1.1, 0.12, 0.75] as const };
const amber = { index: 1.45, absorption: [0.06, 0.4, 1.7] as const };
const rose = { index: 1.4, absorption: [0.08, 1.1, 0.45] as const };

export const colouredLight: ScenePreset = {
  id: 'coloured-light',
  reason:
    'Light fades on its way through coloured glass, and with distance: without the first, glass ' +
    'would cast no shadow.',
  compare: 'off:coloured-shadow',
  scene: {
    title: 'light through coloured glass',
    camera: { eye: [0.6, 4.4, 8.6], target: [0.1, 0.55, -0.4], angle: 34 },
    background: PAPER,
    ambient: 0.16,
    effects: { 'coloured-shadow': { light: 'dimmed' } },
    things: [
      floor('#f3efe6'),
      {
        id: 'green cylinder',
        shape: { kind: 'cylinder', center: [-1.7, 0, -0.3], radius: 0.6 },
        material: material('#ffffff', { glass: leaf }),
        between: [0.01, 1.9],
        capped: true,
      },
      {
        id: 'amber cone',
        shape: { kind: 'cone', vertex: [0.3, 1.9, -0.9], slope: 0.42 },
        material: material('#ffffff', { glass: amber }),
        between: [0.01, 1.9],
        capped: true,
      },
      ball('rose ball', [1.75, 0.72, 0.3], 0.7, material('#ffffff', { glass: rose })),
      ball('stone', [-0.35, 0.4, 1.3], 0.4, material(STONE)),
    ],
    lights: [
      {
        light: 'point',
        id: 'lamp',
        colour: '#fff3df',
        strength: 0.95,
        at: [-0.6, 5.2, -4.2],
        effects: { 'fall-off': { full: 6 } },
      },
    ],
  },
};
