import type { Scene } from '../../../../src/scene/types.ts';

/* Links that people have, with the scenes that they were made of, word for word. */

const DULL = { strength: 0, exponent: 20 };
const camera: Scene['camera'] = { eye: [1.5, 3, 9], target: [0, 1, 0], angle: 34 };
const background = { low: '#e9e4da', high: '#f4f3ef' };
const SCENES: readonly Scene[] = [
  {
    title: 'a glass',
    camera,
    background,
    ambient: 0.25,
    things: [
      {
        id: 'glass',
        shape: { kind: 'cylinder', center: [0, 1, 0], radius: 0.75 },
        material: {
          paint: { pattern: 'plain', colour: '#ffffff' },
          shine: { strength: 0.1, exponent: 200 },
          mirror: 0,
          glass: { index: 1.5, absorption: [0.2, 0.8, 2.4] },
        },
        between: [0, 2],
        capped: true,
      },
    ],
    lights: [{ light: 'point', id: 'lamp', colour: '#fff6e6', strength: 0.6, at: [-4, 7, 5] }],
  },
  {
    title: 'a mirror',
    camera,
    background,
    ambient: 0,
    things: [
      {
        id: 'floor',
        shape: { kind: 'plane', normal: [0, 1, 0], point: [0, -0.5, 0] },
        material: {
          paint: { pattern: 'checker', colour: '#e3ddd1', other: '#b3ac9e', size: 1 },
          shine: DULL,
          mirror: 0.35,
        },
      },
    ],
    lights: [{ light: 'sun', id: 'sun', colour: '#ffffff', strength: 0.8, towards: [-1, 2, 2] }],
  },
  {
    title: 'soft',
    camera,
    background,
    ambient: 0.5,
    things: [
      {
        id: 'cone',
        shape: { kind: 'cone', vertex: [0, 2, 0], slope: 0.5 },
        material: {
          paint: { pattern: 'stripes', colour: '#6d97c4', other: '#f1ede4', size: 0.3, axis: 'y' },
          shine: DULL,
          mirror: 0,
        },
        between: [0, 2],
        capped: false,
      },
    ],
    lights: [
      { light: 'sphere', id: 'globe', colour: '#ffffff', strength: 0.6, at: [-4, 7, 5], radius: 1 },
    ],
  },
];

const LINKS = [
  '~XZFRboNADESvUrm_W7QhkDS5SsSHQxxYZWHRsiiJEHfvmLRqVb6MjWeeh5mSS17oSPzWeB5HMlRzJ5HpOJM8M' +
    'TltstJszaEylDg2ktCyZmMsGtw3urwtFkNnrm9NDFN_0VUf7hB9l4MUF4Zo65pWG9fiupUr4Xvuzk56qNksL6H' +
    'dur4ZoT2TgwL90IwtD7CY6eZUmeqnRyFRQbGO4hcn8sVN0LDZvoRDxxg79ro9sFMvLRK6PZQGj57KBB8myABuf' +
    'RRuBM3qOqYofZPAbrONIXkMoV-pc2vVwsUYsGvNNzBWFO9BR42N-DyGOCQXYHjCocZmnybPimrRxCTdRdaJyYF' +
    'f8zAIbkxxkgXvHpmlVyRrqcxBzzCviDx3w3_-new0tD_UO1DoP_sozN6U1VItXw',
  '~TZDBboMwEER_pdpenciERGryKxWHBRawMDYyRmmL-PeOzSHhtMx6387sRtFEK_Qg_phMCD6QooYnCUyPjeQXr' +
    'e_ifFOluleKIodeIiStCqUhsOvTdHndFdXcjH3wq2vTqPVPUD_lLteWAR1MPyShu3aldIT3PNVGHGga4MG4fgF' +
    '4I4Nx6qzPVpaBZ_A3Gk3C0mzZCXTnw8T2zcjsTULh_6RhV1dYMHGUYNKzjWbO_VREqA6sZpBmlBzYW7-GbLds2' +
    '7aA5OOAFpS65OaeVi7mD04KcBeYzaaWGMT1EbkQQX5m73Kei07Lj2s-9Lm87TscWhwgHhFzCfiyOoBz4KN8Gen' +
    'yl9a-dpy_cCj_5NAmzKlQF3Wp9mr_Bw',
  '~RZHRboMwDEX_xXvNKii0VfsrUx8CGIiaJlGSrnSIf991pqk8hav4-NhZKZtsmS6U_JhJUa_vHDVdVuIX4q96d' +
    '1CNOl8VZR0nzogqVasKgXaTVDbtpqjT_W2K_uEGKbX-CeIHn7kdNKCzmWYJxnZseCTc1_fOsAOtAp_ybNyUgF7' +
    'JAEC9d4yyNOuABivdjHD_42-OmZcisi8iyXq5BxTId505Gm2lLmgjPeSQkToZM0cTOMmk3vpHFK3jcD71LSKfZ' +
    'y7JWPPAkiTzU8gNlBcDRXqJfoJwMQOO3ZQxXaWIlwBD6bivxMTE6IGTc8f5yQwBkYZyr0NgzDRqm3hDYLGi_Le' +
    'CchTVABsZuOxksr6Tn7f2WD6RfEvsjhCVR_ps1UkdAI56MA-A6-26_QI',
];

export const OLD_SCENES = SCENES.map((scene, i) => ({ scene, link: LINKS[i] ?? '' }));
