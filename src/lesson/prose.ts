import type { Condition } from './condition.ts';

/** A piece of a formula in prose. */
export type FormulaPart =
  /** A letter with an optional index: r, E with x, t with 1. */
  | { readonly type: 'symbol'; readonly base: string; readonly index: string }
  /** A number that is written out. */
  | { readonly type: 'number'; readonly text: string }
  /** A sign, a bracket, a power. */
  | { readonly type: 'sign'; readonly text: string }
  | { readonly type: 'power'; readonly text: string }
  /** The value that the page shows. */
  | { readonly type: 'live'; readonly quantity: string };

export type Inline =
  | { readonly type: 'text'; readonly text: string }
  | { readonly type: 'strong' | 'em'; readonly inside: readonly Inline[] }
  | { readonly type: 'link'; readonly href: string; readonly inside: readonly Inline[] }
  | { readonly type: 'formula'; readonly parts: readonly FormulaPart[] }
  | { readonly type: 'live'; readonly quantity: string }
  | { readonly type: 'break' }
  /** Claims that make the words before true; for tests, not shown. */
  | { readonly type: 'claims'; readonly claims: readonly string[] };

/** Shown while all its conditions hold; always without any. */
interface Shown {
  readonly when: readonly Condition[];
}

export type Block = Shown &
  (
    | { readonly type: 'paragraph'; readonly inside: readonly Inline[] }
    | { readonly type: 'display'; readonly parts: readonly FormulaPart[] }
    | {
        readonly type: 'list';
        readonly ordered: boolean;
        readonly items: readonly (readonly Inline[])[];
      }
    | { readonly type: 'code'; readonly text: string }
    /** Place of the step's slider. */
    | { readonly type: 'slider' }
  );

export type Prose = readonly Block[];

/** All inline parts of a text, also nested ones. */
export function inlinesOf(prose: Prose): Inline[] {
  const within = (parts: readonly Inline[]): Inline[] =>
    parts.flatMap((part) => ('inside' in part ? [part, ...within(part.inside)] : [part]));
  return prose.flatMap((block) => {
    if (block.type === 'paragraph') return within(block.inside);
    if (block.type === 'list') return block.items.flatMap(within);
    return block.type === 'display' ? [{ type: 'formula' as const, parts: block.parts }] : [];
  });
}

/** The letters in the formulas and live numbers of a text. */
export function lettersIn(prose: Prose): ReadonlySet<string> {
  const inFormulas = inlinesOf(prose).flatMap((part) =>
    part.type !== 'formula'
      ? []
      : part.parts.flatMap((one) => (one.type === 'symbol' ? [one.base] : [])),
  );
  return new Set([...inFormulas, ...quantitiesIn(prose).map((name) => name.charAt(0))]);
}

/** The names of all live numbers of a text. */
export function quantitiesIn(prose: Prose): string[] {
  return inlinesOf(prose).flatMap((part) => {
    if (part.type === 'live') return [part.quantity];
    if (part.type !== 'formula') return [];
    return part.parts.flatMap((one) => (one.type === 'live' ? [one.quantity] : []));
  });
}
