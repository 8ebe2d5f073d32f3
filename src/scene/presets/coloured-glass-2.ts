import { ball, material, PAPER, type ScenePreset, table } from './define.ts';

const leaf = { index: 1.5, absorption: [2.1, 0.3, 1.25] as const };
const amber = { index: 1.45, absorption: [0.1, 0.55, 2.1] as const };
const rose = { index: 1.4, absorption: [0.25, 2, 0.95] as const };

export const colouredGlass2: ScenePreset = {
  id: 'coloured-glass.2',
  reason: 'Coloured glass is darker where the chord through it is longer: e^(−σ · chord).',
  compare: 'off:absorption',
  scene: {
    title: 'coloured glass',
    camera: { eye: [0.6, 3.7, 8.6], target: [0.05, 0.72, 0], angle: 30 },
    background: PAPER,
    ambient: 0.34,
    things: [
      table(3.3, { pattern: 'checker', colour: '#eee8db', other: '#c9c1b1', size: 0.55 }),
      {
        id: 'green cylinder',
        shape: { kind: 'cylinder', center: [-1.75, 0, -0.15], radius: 0.68 },
        material: material('#ffffff', { glass: leaf }),
        between: [0.02, 1.75],
        capped: true,
      },
      {
        id: 'amber cone',
        shape: { kind: 'cone', vertex: [0.15, 2.15, -0.55], slope: 0.42 },
        material: material('#ffffff', { glass: amber }),
        between: [0.02, 2.15],
        capped: true,
      },
      ball('rose ball', [1.75, 0.76, 0.55], 0.74, material('#ffffff', { glass: rose })),
    ],
    lights: [{ light: 'sun', id: 'sun', colour: '#ffffff', strength: 0.72, towards: [-1, 3, 2] }],
  },
};
