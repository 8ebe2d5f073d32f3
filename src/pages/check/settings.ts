import { CASES_SEED } from '../../check/program/cases.ts';
import { plan } from '../../check/session.ts';
import {
  CHOSEN,
  type Chosen,
  FIRST_SET,
  isSet,
  partsOf as partsOfSet,
  SETS,
  setId,
  setProblem,
} from '../../check/sets.ts';
import { findShape } from '../../math/shapes.ts';
import type { Settings } from '../../state/state.ts';
import type { Readable } from '../page.ts';

/** The parts of the page; a wide one takes the whole width. */
export const PARTS = [
  { id: 'questions', title: 'Questions', wide: false },
  { id: 'own', title: 'Own numbers', wide: false },
  { id: 'program', title: 'Own program', wide: false },
  { id: 'set', title: 'Make a set', wide: true },
  { id: 'class', title: 'Mark a class', wide: true },
] as const;
export type PartId = (typeof PARTS)[number]['id'];

/** The settings of the page, which its link carries. */
export interface CheckSettings {
  readonly part: PartId;
  /** The id of the question set that the seed draws from, with what is chosen beside. */
  readonly set: string;
  readonly seed: number;
  /** A student's name or number, who gets own numbers by it; '' for the seed's. */
  readonly who: string;
  /** Index of the question, from 0. */
  readonly question: number;
  /** Which shape's cases a program gets: a kind, or 'all' for the set's shapes. */
  readonly cases: string;
  /** The seed of those cases. */
  readonly casesSeed: number;
}

const DEFAULTS: CheckSettings = {
  part: 'questions',
  set: FIRST_SET,
  seed: 1,
  who: '',
  question: 0,
  cases: 'cylinder',
  casesSeed: CASES_SEED,
};

/** Keys are left out where they have their default. */
export const KEYS = [
  'part',
  'set',
  ...CHOSEN,
  'seed',
  'who',
  'question',
  'cases',
  'cases-seed',
] as const;

/** Most characters of a name in a link. */
export const LONGEST_NAME = 60;

const isPart = (text: string): text is PartId => PARTS.some(({ id }) => id === text);
const isSeed = (text: string): boolean => /^-?\d{1,9}$/.test(text);
/** Every session of a set has as many questions. */
const questionsIn = (set: string): number => plan(DEFAULTS.seed, set).length;
const isQuestion = (text: string, set: string): boolean =>
  /^\d{1,3}$/.test(text) && Number(text) >= 1 && Number(text) <= questionsIn(set);
const isCases = (text: string): boolean => text === 'all' || findShape(text) !== undefined;

/** The id of a link's set; the first set where it names none that there is. */
function setIn(settings: Settings): string {
  const base = settings.set ?? FIRST_SET;
  const chosen: Record<string, string> = {};
  for (const key of CHOSEN) {
    const text = settings[key];
    if (text !== undefined && isSet(setId(base, { ...chosen, [key]: text }))) chosen[key] = text;
  }
  const id = setId(base, chosen);
  return isSet(id) ? id : FIRST_SET;
}

/** Whether a text is valid with this set, and words on what it has to be. */
type Rule = readonly [
  (text: string, set: string) => boolean,
  (set: string, text: string) => string,
];

const isBase = (text: string, set: string): boolean => partsOfSet(set).base === text;

function setWords(_: string, text: string): string {
  const known = Object.keys(SETS).join(', ');
  const reason = /^[a-z]/.test(text) ? setProblem(text) : '';
  const words = reason ? `${reason}; numbered sets: ${known}` : known;
  return `a set of questions (${words}), so set ${FIRST_SET} is opened`;
}

const chosenRule = (key: (typeof CHOSEN)[number]): Rule => [
  (text, set) => partsOfSet(set).chosen[key] === text,
  (set, text) => {
    const { base } = partsOfSet(set);
    return `usable (${setProblem(setId(base, { [key]: text } as Chosen))})`;
  },
];

const CHECKS: Readonly<Record<string, Rule>> = {
  part: [
    isPart,
    () =>
      PARTS.map(({ id }) => id)
        .join(', ')
        .replace(/, (\w+)$/, ' or $1'),
  ],
  set: [isBase, setWords],
  shapes: chosenRule('shapes'),
  level: chosenRule('level'),
  hints: chosenRule('hints'),
  seed: [isSeed, () => 'a whole number of up to nine digits'],
  who: [
    (text) => text.trim() !== '' && text.length <= LONGEST_NAME,
    () => `a name or number of up to ${LONGEST_NAME} characters`,
  ],
  question: [isQuestion, (set) => `a question from 1 to ${questionsIn(set)}`],
  cases: [isCases, () => 'a shape, or all'],
  'cases-seed': [
    (text) => /^\d{1,9}$/.test(text),
    () => 'a whole number from 0 on of up to nine digits',
  ],
};

/** What is wrong with a seed that was typed; '' for nothing. */
export function seedProblem(key: 'seed' | 'cases-seed', text: string): string {
  const [ok, wanted] = CHECKS[key] ?? UNKNOWN;
  return ok(text, FIRST_SET) ? '' : `'${text.slice(0, 40)}' is not ${wanted(FIRST_SET, text)}.`;
}

const UNKNOWN: Rule = [() => false, () => ''];

/** The valid settings of a link, and what is wrong with the others. */
export function readSettings(settings: Settings): Readable {
  const usable: Record<string, string> = {};
  const problems: string[] = [];
  const set = setIn(settings);
  for (const [key, text] of Object.entries(settings)) {
    // A link may have any key, also the name of an inherited property ('toString').
    const [ok, wanted] = Object.hasOwn(CHECKS, key) ? (CHECKS[key] ?? UNKNOWN) : UNKNOWN;
    const words = wanted(set, text);
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
    set: setIn(own),
    seed: own.seed === undefined ? DEFAULTS.seed : Number(own.seed),
    who: own.who ?? DEFAULTS.who,
    question: own.question === undefined ? DEFAULTS.question : Number(own.question) - 1,
    cases: own.cases ?? DEFAULTS.cases,
    casesSeed: Number(own['cases-seed'] ?? DEFAULTS.casesSeed),
  };
}

/** The texts of these settings; null for a default. */
export function settingsFor(wanted: Partial<CheckSettings>): Record<string, string | null> {
  const texts: Record<string, string | null> = {};
  const put = (key: (typeof KEYS)[number], text: string, initial: string): void => {
    texts[key] = text === initial ? null : text;
  };
  if (wanted.part !== undefined) put('part', wanted.part, DEFAULTS.part);
  if (wanted.set !== undefined) {
    const { base, chosen } = partsOfSet(wanted.set);
    put('set', base, DEFAULTS.set);
    for (const key of CHOSEN) texts[key] = chosen[key] ?? null;
  }
  if (wanted.seed !== undefined) put('seed', String(wanted.seed), String(DEFAULTS.seed));
  if (wanted.who !== undefined) put('who', wanted.who.trim(), DEFAULTS.who);
  if (wanted.question !== undefined) {
    put('question', String(wanted.question + 1), String(DEFAULTS.question + 1));
  }
  if (wanted.cases !== undefined) put('cases', wanted.cases, DEFAULTS.cases);
  if (wanted.casesSeed !== undefined) {
    put('cases-seed', String(wanted.casesSeed), String(DEFAULTS.casesSeed));
  }
  return texts;
}
