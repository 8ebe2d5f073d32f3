import { definitionOf } from '../math/shapes.ts';
import type { Posed } from './compose.ts';
import type { Told } from './exercises/define.ts';

/** Subscripts of what a question gives. */
const NAMES: Readonly<Record<string, string>> = { t1: 't₁', t2: 't₂' };

/** What a question gives beside its sentence, for the page, for paper and for files. */
interface Asked {
  /** What it is about: a shape's title, or what the exercise says. */
  readonly subject: string;
  /** Which of E, d and the shape's numbers are given. */
  readonly input: 'all' | 'E' | 'none';
  /** The key of the shape's number that is asked for; null if none is. */
  readonly unknown: string | null;
  readonly told: readonly Told[];
  /** What its picture shows, in words; '' without one. */
  readonly described: string;
}

export function askedOf({ exercise, draft }: Posed): Asked {
  const { hidden, subject, asksForParam } = exercise;
  return {
    subject: subject ?? definitionOf(draft.shape).title,
    input: hidden === undefined ? 'all' : hidden === 'all' ? 'none' : 'E',
    unknown: asksForParam ? (draft.param?.key ?? null) : null,
    told: (exercise.told?.(draft) ?? []).map(({ name, says }) => ({ name: capital(name), says })),
    described: exercise.described?.(draft) ?? '',
  };
}

export const capital = (words: string): string =>
  `${words.charAt(0).toUpperCase()}${words.slice(1)}`;

export const givenName = (id: string): string => NAMES[id] ?? id;
