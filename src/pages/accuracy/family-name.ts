import { findFamily } from '../../math/families.ts';

/** The families that have a tab of their own. */
export const TIMED: readonly { readonly id: string; readonly title: string }[] = [
  { id: 'typical', title: 'typical' },
  { id: 'far-origin', title: 'far away' },
  { id: 'near-tangent', title: 'near tangent' },
  { id: 'near-surface', title: 'near surface' },
];

/** The family's name in its tab, else its title. */
export const familyName = (id: string): string =>
  TIMED.find((one) => one.id === id)?.title ?? findFamily(id)?.title ?? id;
