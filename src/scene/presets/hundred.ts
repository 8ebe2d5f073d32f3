import type { Thing } from '../types.ts';
import {
  BLUE,
  ball,
  floor,
  material,
  PAPER,
  SAND,
  type ScenePreset,
  STONE,
  TEAL,
  VIOLET,
} from './define.ts';

const COLOURS = [VIOLET, SAND, BLUE, TEAL];

/** Thing k of a grid of ten by ten, with kinds in turn. */
export function thing(k: number): Thing {
  const x = (k % 10) * 1.2 - 5.4;
  const z = Math.floor(k / 10) * -1.2;
  const paint = material(COLOURS[(k + Math.floor(k / 10)) % 4] ?? VIOLET);
  const kinds: readonly Thing[] = [
    ball(`ball ${k}`, [x, 0.4, z], 0.4, paint),
    {
      id: `cone ${k}`,
      shape: { kind: 'cone', vertex: [x, 1, z], slope: 0.4 },
      material: paint,
      between: [0, 1],
    },
    {
      id: `cylinder ${k}`,
      shape: { kind: 'cylinder', center: [x, 0, z], radius: 0.35 },
      material: paint,
      between: [0, 0.8],
    },
    {
      id: `hyperboloid ${k}`,
      shape: { kind: 'hyperboloid', center: [x, 0.5, z], flare: 0.3, radius: 0.25 },
      material: paint,
      between: [0, 1],
    },
    {
      id: `circle ${k}`,
      shape: { kind: 'circle', normal: [0.3, 1, 0.4], center: [x, 0.4, z], radius: 0.4 },
      material: paint,
    },
    {
      id: `square ${k}`,
      shape: { kind: 'square', corner: [x - 0.35, 0, z], side: 0.7, axis: 'z' },
      material: paint,
    },
  ];
  return kinds[k % kinds.length] ?? ball(`ball ${k}`, [x, 0.4, z], 0.4, paint);
}

export const hundred: ScenePreset = {
  id: 'hundred',
  reason: 'A hundred shapes: boxes around boxes keep most questions from being asked.',
  compare: 'off:boxes',
  scene: {
    title: 'a hundred shapes',
    camera: { eye: [2, 6, 8], target: [0, 0, -4], angle: 40 },
    background: PAPER,
    ambient: 0.25,
    things: [floor(STONE), ...Array.from({ length: 100 }, (_, k) => thing(k))],
    lights: [{ light: 'point', id: 'lamp', colour: '#ffffff', strength: 0.8, at: [-5, 9, 4] }],
  },
};
