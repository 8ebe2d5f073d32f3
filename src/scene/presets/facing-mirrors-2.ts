import {
  BLUE,
  ball,
  floor,
  material,
  PAPER,
  SAND,
  type ScenePreset,
  TEAL,
  WOOD,
} from './define.ts';

const GLASS = material('#c9d2d6', { mirror: 0.85 });
const WALL = material('#e7ded0');

export const facingMirrors2: ScenePreset = {
  id: 'facing-mirrors.2',
  reason: 'Two mirrors face each other: each ray goes on until it can no longer change its pixel.',
  compare: 'bounces:1',
  scene: {
    title: 'mirrors that face each other',
    camera: { eye: [0.75, 1.75, 2.6], target: [-0.12, 1.3, -3], angle: 50 },
    background: PAPER,
    ambient: 0.3,
    things: [
      floor('#d8cfc0'),
      {
        id: 'near mirror',
        shape: { kind: 'square', corner: [-1.7, 0.1, 2.98], side: 2.9, axis: 'z' },
        material: GLASS,
      },
      {
        id: 'near frame',
        shape: { kind: 'square', corner: [-1.85, -0.05, 2.99], side: 3.2, axis: 'z' },
        material: material(WOOD),
      },
      {
        id: 'near wall',
        shape: { kind: 'square', corner: [-8, 0, 3], side: 16, axis: 'z' },
        material: WALL,
      },
      {
        id: 'far mirror',
        shape: { kind: 'square', corner: [-1.7, 0.1, -2.98], side: 2.9, axis: 'z' },
        material: GLASS,
      },
      {
        id: 'far frame',
        shape: { kind: 'square', corner: [-1.85, -0.05, -2.99], side: 3.2, axis: 'z' },
        material: material(WOOD),
      },
      {
        id: 'far wall',
        shape: { kind: 'square', corner: [-8, 0, -3], side: 16, axis: 'z' },
        material: WALL,
      },
      ball('ball', [-0.95, 0.55, -0.9], 0.55, material(TEAL)),
      ball('small ball', [0.62, 0.34, -1.5], 0.34, material(SAND)),
      {
        id: 'cylinder',
        shape: { kind: 'cylinder', center: [2.35, 0, -2], radius: 0.42 },
        material: material(BLUE),
        between: [0, 1.5],
      },
    ],
    lights: [
      { light: 'point', id: 'lamp', colour: '#fff6e8', strength: 0.75, at: [0.6, 4.6, 0.8] },
    ],
  },
};
