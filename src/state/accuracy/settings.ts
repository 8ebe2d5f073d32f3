import { FAMILIES, findFamily } from '../../math/families.ts';

/** What the two plots of the Accuracy page show; a link carries it. */
export interface AccuracySettings {
  /** The family whose rays are measured. */
  readonly family: string;
  /** Where its dial stands; null: where the family itself turns it. */
  readonly dial: number | null;
  readonly worth: Worth;
  readonly cost: Cost;
  /** The family whose difficulty is swept. */
  readonly hard: string;
  readonly seed: number;
}

export const WORTHS = [
  { id: 'digits', title: 'digits, 9 rays of 10' },
  { id: 'worst', title: 'digits, worst ray' },
  { id: 'wrong', title: 'wrong verdicts' },
] as const;
export type Worth = (typeof WORTHS)[number]['id'];

export const COSTS = [
  { id: 'ns', title: 'ns' },
  { id: 'times', title: '× textbook' },
] as const;
export type Cost = (typeof COSTS)[number]['id'];

export const INITIAL_ACCURACY: AccuracySettings = {
  family: 'far-origin',
  dial: null,
  worth: 'digits',
  cost: 'ns',
  hard: 'far-origin',
  seed: 7,
};

/** The families that stand above the plots; the rest are in a list. */
export const USUAL_FAMILIES = [
  'typical',
  'mix',
  'far-origin',
  'near-tangent',
  'near-generator',
  'near-surface',
];

export const familyTitle = (id: string): string => findFamily(id)?.title ?? id;
export const families = FAMILIES;
