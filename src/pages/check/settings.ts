import { plan } from '../../check/session.ts';
import { FIRST_SET, isSet, SETS } from '../../check/sets.ts';
import { findShape } from '../../math/shapes.ts';
import type { Settings } from '../../state/state.ts';
import type { Readable } from '../page.ts';

export const PARTS = [
  { id: 'questions', title: 'Questions' },
  { id: 'own', title: 'Own numbers' },
  { id: 'program', title: 'Own program' },
] as const;
export type PartId = (typeof PARTS)[number]['id'];

/** The settings of the page, which its link carries. */
export interface CheckSettings {
  readonly part: PartId;
  /** The question set that the seed draws from. */
  readonly set: string;
  readonly seed: number;
  /** Index of the question, from 0. */
  readonly question: number;
  /** Which shape's cases a program gets: a kind, or 'all' for the set's shapes. */
  readonly cases: string;
}

const DEFAULTS: CheckSettings = {
  part: 'questions',
  set: FIRST_SET,
  seed: 1,
  question: 0,
  cases: 'cylinder',
};

/** Keys are left out where they have their default. */
export const KEYS = ['part', 'set', 'seed', 'question', 'cases'] as const;

const isPart = (text: string): text is PartId => PARTS.some(({ id }) => id === text);
const isSeed = (text: string): boolean => /^-?\d{1,9}$/.test(text);
/** Every session of a set has as many questions. */
const questionsIn = (set: string): number => plan(DEFAULTS.seed, set).length;
const isQuestion = (text: string, set: string): boolean =>
  /^\d{1,3}$/.test(text) && Number(text) >= 1 && Number(text) <= questionsIn(set);
const isCases = (text: string): boolean => text === 'all' || findShape(text) !== undefined;

/** Whether a text is valid with this set, and words on what it has to be. */
type Rule = readonly [(text: string, set: string) => boolean, (set: string) => string];

const CHECKS: Readonly<Record<string, Rule>> = {
  part: [isPart, () => 'questions, own or program'],
  set: [
    isSet,
    () => `a set of questions (${Object.keys(SETS).join(', ')}), so set ${FIRST_SET} is opened`,
  ],
  seed: [isSeed, () => 'a whole number of up to nine digits'],
  question: [isQuestion, (set) => `a question from 1 to ${questionsIn(set)}`],
  cases: [isCases, () => 'a shape, or all'],
};

const UNKNOWN: Rule = [() => false, () => ''];

/** The valid settings of a link, and what is wrong with the others. */
export function readSettings(settings: Settings): Readable {
  const usable: Record<string, string> = {};
  const problems: string[] = [];
  const set = isSet(settings.set ?? '') ? (settings.set ?? '') : DEFAULTS.set;
  for (const [key, text] of Object.entries(settings)) {
    // A link may have any key, also the name of an inherited property ('toString').
    const [ok, wanted] = Object.hasOwn(CHECKS, key) ? (CHECKS[key] ?? UNKNOWN) : UNKNOWN;
    const words = wanted(set);
    if (ok(text, set)) usable[key] = text;
    else if (words) problems.push(`opened without ${key}: '${text.slice(0, 40)}' is not ${words}`);
    else problems.push(`'${key.slice(0, 40)}' means nothing on this page`);
  }
  return { settings: usable, problems };
}

export function settingsOf(settings: Settings): CheckSettings {
  const { settings: own } = readSettings(settings);
  return {
    part: (own.part as PartId | undefined) ?? DEFAULTS.part,
    set: own.set ?? DEFAULTS.set,
    seed: own.seed === undefined ? DEFAULTS.seed : Number(own.seed),
    question: own.question === undefined ? DEFAULTS.question : Number(own.question) - 1,
    cases: own.cases ?? DEFAULTS.cases,
  };
}

/** The texts of these settings; null for a default. */
export function settingsFor(wanted: Partial<CheckSettings>): Record<string, string | null> {
  const texts: Record<string, string | null> = {};
  const put = (key: keyof CheckSettings, text: string, initial: string): void => {
    texts[key] = text === initial ? null : text;
  };
  if (wanted.part !== undefined) put('part', wanted.part, DEFAULTS.part);
  if (wanted.set !== undefined) put('set', wanted.set, DEFAULTS.set);
  if (wanted.seed !== undefined) put('seed', String(wanted.seed), String(DEFAULTS.seed));
  if (wanted.question !== undefined) {
    put('question', String(wanted.question + 1), String(DEFAULTS.question + 1));
  }
  if (wanted.cases !== undefined) put('cases', wanted.cases, DEFAULTS.cases);
  return texts;
}
