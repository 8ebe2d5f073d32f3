import type { Texts } from './grade.ts';
import type { Judged } from './judge.ts';
import { plan } from './session.ts';
import { FIRST_SET } from './sets.ts';

/** A student's progress on one question. */
export interface Asked {
  /** The texts in the boxes. */
  readonly texts: Texts;
  /** Number of answers that were right or wrong; unreadable ones do not count. */
  readonly tries: number;
  /** The try at which it was right, or null. */
  readonly solvedAt: number | null;
  readonly hints: number;
  readonly solutionShown: boolean;
  /** Ids of the misconceptions that were named, each once. */
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
 * The progress after a judged answer. An answer that could not be read or has too few digits is no
 * try, and none counts after the solution was shown or the question was solved.
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

/** A stored session; null for any other text, since the storage may hold anything. */
export function readProgress(text: string | null): Progress | null {
  try {
    const value: unknown = JSON.parse(text ?? '');
    if (!isRecord(value) || !Number.isSafeInteger(value.seed) || !isRecord(value.asked))
      return null;
    // Sessions that were stored before there were sets belong to the first one.
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

/** Renames the field 't' of flat questions, as older versions stored it, to 't1'. */
function renamed(texts: Texts, exercise: string | undefined): Texts {
  const { t, ...others } = texts;
  return exercise === 'flat' && t !== undefined ? { t1: t, ...others } : texts;
}

/** Largest number of stored sessions; the one that was used longest ago is dropped. */
const MOST_SESSIONS = 12;

/** All stored sessions, the latest last; unreadable ones are left out. */
export function readSessions(text: string | null): readonly Progress[] {
  try {
    const list: unknown = JSON.parse(text ?? '');
    if (!Array.isArray(list)) return [];
    return list.slice(-MOST_SESSIONS).flatMap((one) => readProgress(JSON.stringify(one)) ?? []);
  } catch {
    return [];
  }
}

/** The sessions with this one put last. */
export function withSession(all: readonly Progress[], progress: Progress): readonly Progress[] {
  const others = all.filter(({ seed, set }) => seed !== progress.seed || set !== progress.set);
  return [...others, progress].slice(-MOST_SESSIONS);
}

const isRecord = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const isCount = (value: unknown): value is number =>
  Number.isSafeInteger(value) && (value as number) >= 0;

/** A question as it was stored; null for anything else. */
export function readAsked(value: unknown): Asked | null {
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
