import type { Texts } from './grade.ts';
import type { Judged } from './judge.ts';
import { plan } from './session.ts';
import { FIRST_SET } from './sets.ts';

/** How far one question got. */
export interface Asked {
  /** What stands in the boxes. */
  readonly texts: Texts;
  /** Answers that were judged; invalid ones are no tries. */
  readonly tries: number;
  /** The try at which it was right, or null. */
  readonly solvedAt: number | null;
  readonly hints: number;
  readonly solutionShown: boolean;
  /** Misconceptions that were named, once each. */
  readonly causes: readonly string[];
}

/** A session's seed and set, and its questions by number, from 0. */
export interface Progress {
  readonly seed: number;
  readonly set: string;
  readonly asked: Readonly<Record<string, Asked>>;
}

const FRESH: Asked = {
  texts: {},
  tries: 0,
  solvedAt: null,
  hints: 0,
  solutionShown: false,
  causes: [],
};

export const started = (seed: number, set: string = FIRST_SET): Progress => ({
  seed,
  set,
  asked: {},
});

export const askedAt = (progress: Progress, index: number): Asked => progress.asked[index] ?? FRESH;

const changed = (progress: Progress, index: number, by: Partial<Asked>): Progress => ({
  ...progress,
  asked: { ...progress.asked, [index]: { ...askedAt(progress, index), ...by } },
});

export const typed = (progress: Progress, index: number, field: string, text: string): Progress =>
  changed(progress, index, { texts: { ...askedAt(progress, index).texts, [field]: text } });

/**
 * A judged answer; one that could not be read, or has too few digits, is no try. What comes after
 * the solution was shown, or after a right answer, no longer counts.
 */
export function tried(progress: Progress, index: number, judged: Judged): Progress {
  const before = askedAt(progress, index);
  const counts = judged.verdict === 'correct' || judged.verdict === 'wrong';
  if (!counts || before.solvedAt !== null || before.solutionShown) {
    return progress;
  }
  const tries = before.tries + 1;
  const causes = [...new Set([...before.causes, ...judged.causes.map(({ id }) => id)])];
  return changed(progress, index, {
    tries,
    causes,
    solvedAt: judged.verdict === 'correct' ? tries : null,
  });
}

export const hinted = (progress: Progress, index: number, most: number): Progress =>
  changed(progress, index, { hints: Math.min(most, askedAt(progress, index).hints + 1) });

export const solutionShown = (progress: Progress, index: number): Progress =>
  changed(progress, index, { solutionShown: true });

/** A stored session; null for a text that is none, since the device may hold anything. */
export function readProgress(text: string | null): Progress | null {
  try {
    const value: unknown = JSON.parse(text ?? '');
    if (!isRecord(value) || !Number.isSafeInteger(value.seed) || !isRecord(value.asked))
      return null;
    // What was kept before there were sets is of the first one.
    const { set = FIRST_SET } = value;
    if (typeof set !== 'string') return null;
    const slots = plan(value.seed as number, set);
    const asked = Object.entries(value.asked).flatMap(([index, one]) => {
      const read = readAsked(one);
      if (!/^\d{1,3}$/.test(index) || !read) return [];
      const texts = renamed(read.texts, slots[Number(index)]?.exercise);
      return [[index, { ...read, texts }] as const];
    });
    return { seed: value.seed as number, set, asked: Object.fromEntries(asked) };
  } catch {
    return null;
  }
}

/**
 * The t of flat questions was once kept as 't', and is 't1' since: what was typed is still there.
 */
function renamed(texts: Texts, exercise: string | undefined): Texts {
  const { t, ...others } = texts;
  return exercise === 'flat' && t !== undefined ? { t1: t, ...others } : texts;
}

/** Sessions that a device keeps; the one that was touched longest ago goes first. */
const MOST_SESSIONS = 12;

/** All stored sessions, the latest last; anything unreadable is left out. */
export function readSessions(text: string | null): readonly Progress[] {
  try {
    const list: unknown = JSON.parse(text ?? '');
    if (!Array.isArray(list)) return [];
    return list.slice(-MOST_SESSIONS).flatMap((one) => readProgress(JSON.stringify(one)) ?? []);
  } catch {
    return [];
  }
}

/** This session put in, last. */
export function withSession(all: readonly Progress[], progress: Progress): readonly Progress[] {
  const others = all.filter(({ seed, set }) => seed !== progress.seed || set !== progress.set);
  return [...others, progress].slice(-MOST_SESSIONS);
}

const isRecord = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const isCount = (value: unknown): value is number =>
  Number.isSafeInteger(value) && (value as number) >= 0;

function readAsked(value: unknown): Asked | null {
  if (!isRecord(value) || !isCount(value.tries) || !isCount(value.hints)) return null;
  const { texts, solvedAt, causes } = value;
  const words = isRecord(texts) ? Object.entries(texts) : [];
  return {
    texts: Object.fromEntries(words.filter(([, text]) => typeof text === 'string')) as Texts,
    tries: value.tries,
    solvedAt: isCount(solvedAt) ? solvedAt : null,
    hints: value.hints,
    solutionShown: value.solutionShown === true,
    causes: Array.isArray(causes) ? causes.filter((cause) => typeof cause === 'string') : [],
  };
}
