import { InvalidInput } from '../../math/index.ts';
import { quote } from '../../math/shapes.ts';
import type { Wanted } from '../../tracer/budget.ts';

/** The difference from the whole picture that is allowed. */
export interface Budget {
  /** Largest difference of a colour's channel, in levels of 255, not rounded. */
  readonly levels: number;
  /** Share of the pixels that may differ by more, 0 … 1. */
  readonly beyond: number;
}

/** Choices of the difference; half a level cannot be seen on a screen. */
const DIFFERENCES = [
  ['0.5', 'half a level of 255', 0.5],
  ['1', 'one level of 255', 1],
  ['1%', '1 %', 2.55],
  ['2%', '2 %', 5.1],
  ['5%', '5 %', 12.75],
  ['10%', '10 %', 25.5],
] as const;

/** Parts of the pixels that are offered, as texts of percent. */
const PARTS = [
  ['', 'in every pixel', 0],
  ['1', 'in 99 % of the pixels', 0.01],
  ['5', 'in 95 % of the pixels', 0.05],
] as const;

const textOf = (levels: number): string =>
  DIFFERENCES.find(([, , known]) => known === levels)?.[0] ?? String(levels);

/** In a link: '0.5', '2%', and with the percentage of pixels that may differ by more: '2%,1'. */
export const BUDGET = {
  differences: DIFFERENCES.map(([value, words]) => ({ value, words })),
  parts: PARTS.map(([value, words]) => ({ value, words })),
  read(text: string): Budget | null {
    if (text === '') return null;
    const [difference, part = '', ...more] = text.split(',');
    const levels = DIFFERENCES.find(([value]) => value === difference)?.[2];
    const beyond = PARTS.find(([value]) => value === part)?.[2];
    if (levels === undefined || beyond === undefined || more.length > 0) {
      throw new InvalidInput(`${quote(text)} is not a budget like 0.5, 2% or 2%,1`);
    }
    return { levels, beyond };
  },
  /** The two texts of which the link's is made. */
  texts({ levels, beyond }: Budget): readonly [difference: string, part: string] {
    return [textOf(levels), PARTS.find(([, , known]) => known === beyond)?.[0] ?? ''];
  },
  write: (difference: string, part: string): string =>
    part === '' ? difference : `${difference},${part}`,
} as const;

/** Words for the difference that is allowed: '2 %'. */
export const differenceWords = (budget: Budget): string =>
  DIFFERENCES.find(([value]) => value === BUDGET.texts(budget)[0])?.[1] ?? '';

/** Words for a budget: 'no more than 2 % in 99 % of the pixels'. */
export function budgetWords(budget: Budget): string {
  const where = PARTS.find(([value]) => value === BUDGET.texts(budget)[1])?.[1] ?? '';
  return `no more than ${differenceWords(budget)} ${where}`;
}

/** What the search tries after the whole picture, in this order. */
export const TRIED: readonly (readonly [step: Wanted['step'], words: string])[] = [
  ['effects', 'effects are left out, the dearest first, one after another'],
  ['bounces', 'the fewest bounces are looked for'],
  ['methods', 'less accurate methods are tried'],
];
