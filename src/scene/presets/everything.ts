import {
  BLUE,
  ball,
  clear,
  floor,
  GLINT,
  GLOSSY,
  material,
  PAPER,
  SAND,
  type ScenePreset,
  TEAL,
  VIOLET,
} from './define.ts';

export const everything: ScenePreset = {
  id: 'everything',
  reason: 'All effects at once: what the whole ledger looks like.',
  scene: {
    title: 'everything',
    camera: { eye: [0.8, 3.6, 10.5], target: [0, 1, 0], angle: 36 },
    background: PAPER,
    ambient: 0.25,
    effects: { 'coloured-shadow': { light: 'dimmed' } },
    things: [
      floor({ pattern: 'checker', colour: '#e3ddd1', other: '#b3ac9e', size: 1 }),
      {
        id: 'mirror',
        shape: { kind: 'square', corner: [-3.4, 0, -3], side: 4, axis: 'z' },
        material: material('#dfe3e6', { mirror: 0.85 }),
      },
      {
        id: 'glass cone',
        shape: { kind: 'cone', vertex: [-0.4, 2.3, 1.4], slope: 0.4 },
        material: material('#ffffff', { glass: clear(1.5), shine: GLINT }),
        between: [0.02, 2.3],
        capped: true,
      },
      {
        id: 'amber glass',
        shape: { kind: 'cylinder', center: [1.9, 0, 1.6], radius: 0.6 },
        material: material('#ffffff', { glass: { index: 1.45, absorption: [0.2, 0.8, 2.4] } }),
        between: [0.02, 1.4],
        capped: true,
      },
      {
        id: 'hyperboloid',
        shape: { kind: 'hyperboloid', center: [3, 1.3, -1], flare: 0.35, radius: 0.5 },
        material: material(SAND, { shine: GLOSSY }),
        between: [0, 2.6],
      },
      {
        id: 'striped cylinder',
        shape: { kind: 'cylinder', center: [-2.9, 0, 1], radius: 0.7 },
        material: material({
          pattern: 'stripes',
          colour: BLUE,
          other: '#f1ede4',
          size: 0.3,
          axis: 'y',
        }),
        between: [0, 1.7],
      },
      ball('ball', [0.9, 0.7, -0.9], 0.7, material(VIOLET, { shine: GLOSSY })),
      {
        id: 'disc',
        shape: { kind: 'circle', normal: [0.2, 1, 0.6], center: [-1.5, 0.4, 3.2], radius: 0.45 },
        material: material(TEAL),
      },
    ],
    lights: [
      {
        light: 'sphere',
        id: 'globe',
        colour: '#fff6e6',
        strength: 0.75,
        at: [-4, 7, 5],
        radius: 1,
        effects: { 'fall-off': { full: 8 } },
      },
      { light: 'sun', id: 'sun', colour: '#e8f0ff', strength: 0.25, towards: [2, 3, 2] },
    ],
  },
};
