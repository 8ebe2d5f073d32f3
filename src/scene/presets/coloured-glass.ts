import { floor, material, PAPER, type ScenePreset } from './define.ts';

const bottle = { index: 1.5, absorption: [1.6, 0.25, 0.7] as const };
const amber = { index: 1.45, absorption: [0.15, 0.7, 2.2] as const };

export const colouredGlass: ScenePreset = {
  id: 'coloured-glass',
  reason: 'Coloured glass is darker where the chord through it is longer: e^(−σ · chord).',
  compare: 'off:absorption',
  scene: {
    title: 'coloured glass',
    camera: { eye: [0.5, 3, 8], target: [0, 1, 0], angle: 34 },
    background: PAPER,
    ambient: 0.3,
    things: [
      floor({ pattern: 'checker', colour: '#e6e0d4', other: '#b9b2a4', size: 1 }),
      {
        id: 'green cylinder',
        shape: { kind: 'cylinder', center: [-1.3, 0, 0], radius: 0.8 },
        material: material('#ffffff', { glass: bottle }),
        between: [0.05, 2],
        capped: true,
      },
      {
        id: 'amber cone',
        shape: { kind: 'cone', vertex: [1.3, 2.4, 0], slope: 0.45 },
        material: material('#ffffff', { glass: amber }),
        between: [0.05, 2.4],
        capped: true,
      },
    ],
    lights: [{ light: 'sun', id: 'sun', colour: '#ffffff', strength: 0.75, towards: [-1, 3, 2] }],
  },
};
