import {
  BLUE,
  ball,
  clear,
  GLINT,
  GLOSSY,
  material,
  PAPER,
  SAND,
  type ScenePreset,
  TEAL,
  table,
  VIOLET,
  WOOD,
} from './define.ts';

export const everything2: ScenePreset = {
  id: 'everything.2',
  reason: 'All effects at once: what the whole ledger looks like.',
  compare: 'off:soft-shadow',
  scene: {
    title: 'everything',
    camera: { eye: [0.9, 3.7, 10.2], target: [0.05, 0.95, 0], angle: 31 },
    background: PAPER,
    ambient: 0.27,
    effects: { 'coloured-shadow': { light: 'dimmed' } },
    things: [
      table(4.6, { pattern: 'checker', colour: '#ece6da', other: '#c3bbab', size: 0.8 }),
      {
        id: 'mirror',
        shape: { kind: 'square', corner: [-2.35, 0.16, -1.9], side: 2.9, axis: 'z' },
        material: material('#dfe3e6', { mirror: 0.88 }),
      },
      {
        id: 'frame',
        shape: { kind: 'square', corner: [-2.51, 0, -1.92], side: 3.22, axis: 'z' },
        material: material(WOOD),
      },
      {
        id: 'glass cone',
        shape: { kind: 'cone', vertex: [0.35, 2, 1.3], slope: 0.4 },
        material: {
          ...material('#ffffff', { glass: clear(1.5), shine: GLINT }),
          effects: { dispersion: { spread: 0.08 } },
        },
        between: [0.02, 2],
        capped: true,
      },
      {
        id: 'amber glass',
        shape: { kind: 'cylinder', center: [1.85, 0, 2], radius: 0.5 },
        material: material('#ffffff', { glass: { index: 1.45, absorption: [0.12, 0.6, 2] } }),
        between: [0.02, 1.15],
        capped: true,
      },
      {
        id: 'hyperboloid',
        shape: { kind: 'hyperboloid', center: [2.6, 1.15, -1], flare: 0.35, radius: 0.42 },
        material: material(SAND, { shine: GLOSSY }),
        between: [0, 2.3],
      },
      {
        id: 'striped cylinder',
        shape: { kind: 'cylinder', center: [-2.6, 0, 0.7], radius: 0.62 },
        material: material({
          pattern: 'stripes',
          colour: BLUE,
          other: '#f1ede4',
          size: 0.3,
          axis: 'y',
        }),
        between: [0, 1.5],
      },
      ball('ball', [-0.75, 0.62, 0.2], 0.62, material(VIOLET, { shine: GLOSSY })),
      {
        id: 'disc',
        shape: { kind: 'circle', normal: [0.2, 1, 0.6], center: [-1.25, 0.36, 2.35], radius: 0.42 },
        material: material(TEAL),
      },
    ],
    lights: [
      {
        light: 'sphere',
        id: 'globe',
        colour: '#fff3dd',
        strength: 0.72,
        at: [-4, 6.5, 5],
        radius: 0.9,
        effects: { 'fall-off': { full: 8.5 } },
      },
      { light: 'sun', id: 'sun', colour: '#e8f0ff', strength: 0.25, towards: [2, 3, 2] },
    ],
  },
};
