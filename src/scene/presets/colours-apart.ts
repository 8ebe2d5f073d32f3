import { ball, clear, material, PAPER, type ScenePreset, table } from './define.ts';

const flint = {
  ...material('#ffffff', { glass: clear(1.6) }),
  effects: { dispersion: { spread: 0.12 } },
};

export const coloursApart: ScenePreset = {
  id: 'colours-apart',
  reason: 'Glass bends blue more than red: where an edge is seen through it, the colours part.',
  compare: 'off:dispersion',
  scene: {
    title: 'colours apart',
    camera: { eye: [0.5, 3.4, 8.4], target: [0, 0.85, 0], angle: 30 },
    background: PAPER,
    ambient: 0.36,
    things: [
      table(3.4, { pattern: 'checker', colour: '#f6f2ea', other: '#4a4640', size: 0.7 }),
      ball('glass ball', [-1.15, 1.02, 0.3], 1, flint),
      {
        id: 'glass cone',
        shape: { kind: 'cone', vertex: [1.35, 2.3, 0.1], slope: 0.44 },
        material: flint,
        between: [0.02, 2.3],
        capped: true,
      },
    ],
    lights: [{ light: 'sun', id: 'sun', colour: '#ffffff', strength: 0.68, towards: [-1, 3, 2] }],
  },
};
