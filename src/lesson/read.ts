import { definitionOf, quote } from '../math/shapes.ts';
import { createDerive } from '../state/derive.ts';
import type { Example } from '../state/gallery/define.ts';
import { GALLERY } from '../state/gallery/index.ts';
import { questionOf } from '../state/predictions.ts';
import { shapeOf } from '../state/state.ts';
import { decode } from '../state/url.ts';
import { parseNumber } from '../text/parse.ts';
import { freedomOf } from './freedom.ts';
import { CHOSEN_ASKS, type Guess, type Lesson, type Step } from './lesson.ts';
import { proseOf, type Section, sectionsOf, sourceOf, tokensOf } from './markdown.ts';
import { partsOf } from './parts.ts';
import { type Prose, quantitiesIn } from './prose.ts';
import { isQuantity, isQuantityOf } from './quantities.ts';

/*
 * A lesson is Markdown with front matter (docs/ADDING.md, "A lesson"): `title` and `about` between
 * two lines of three dashes, then one heading of level 2 a step. Under it stand lines "key: value"
 * (link or example, part, free, guess, hide), then text, then sections of level 3: Question,
 * Answer, Notes.
 */

export interface ReadLesson {
  readonly lesson: Lesson;
  /** Messages on what could not be read, with the step. */
  readonly problems: readonly string[];
}

/** Most characters of a lesson; a longer file is refused. */
export const LONGEST_LESSON = 100_000;
const MOST_STEPS = 200;
const LONGEST_TITLE = 200;
/** Most messages on one lesson. */
const MOST_PROBLEMS = 12;
const FRONT = /^\s*---[ \t]*\r?\n([\s\S]*?)\r?\n---[ \t]*(?:\r?\n|$)/;
const KEYS = ['link', 'example', 'part', 'free', 'guess', 'hide'];

/** Whether a text looks like a lesson: it begins with front matter. */
export const isLesson = (text: string): boolean => FRONT.test(text);

/** Reads any text; what cannot be read is left out, with a message. */
export function readLesson(text: string, id: string): ReadLesson {
  const problems: string[] = [];
  const all = text.slice(0, LONGEST_LESSON).replace(/\r\n?/g, '\n');
  if (text.length > LONGEST_LESSON) {
    problems.push(`only the first ${LONGEST_LESSON} characters of the lesson are read`);
  }
  const [whole = '', front = ''] = all.match(FRONT) ?? [];
  const keys = pairsOf(front);
  const title = keys.get('title');
  if (!title) problems.push('the lesson has no title');
  for (const key of keys.keys()) {
    if (!['title', 'about'].includes(key))
      problems.push(`${quote(key)} means nothing for a lesson`);
  }
  const sections = sectionsOf(tokensOf(all.slice(whole.length)), 2).slice(1);
  if (sections.length === 0) problems.push('the lesson has no step: "## a title" begins one');
  if (sections.length > MOST_STEPS) problems.push(`only the first ${MOST_STEPS} steps are read`);
  const steps = sections.slice(0, MOST_STEPS).map((section, i) =>
    stepOf(section, (words) => {
      problems.push(`step ${i + 1}: ${words}`);
    }),
  );
  const short = (text = ''): string => text.slice(0, LONGEST_TITLE);
  const lesson = { id, title: short(title) || 'a lesson', about: short(keys.get('about')), steps };
  return { lesson, problems: told(problems) };
}

function told(problems: readonly string[]): readonly string[] {
  const more = problems.length - MOST_PROBLEMS;
  return more > 0 ? [...problems.slice(0, MOST_PROBLEMS), `and ${more} more`] : problems;
}

type Fault = (words: string) => void;

function stepOf(section: Section, fault: Fault): Step {
  const [body, ...parts] = sectionsOf(section.tokens, 3);
  const [head, ...rest] = (body?.tokens ?? []).filter(({ type }) => type !== 'space');
  const given = head?.type === 'paragraph' && isPairs(head.raw) ? pairsOf(head.raw) : null;
  const keys = given ?? new Map<string, string>();
  for (const key of keys.keys()) {
    if (!KEYS.includes(key)) fault(`${quote(key)} means nothing`);
  }
  const part = (name: string): Prose =>
    proseOf(parts.find(({ title }) => title.toLowerCase() === name)?.tokens ?? [], fault);
  for (const { title } of parts) {
    if (!/^(question|answer|notes)$/i.test(title)) fault(`there is no section ${quote(title)}`);
  }
  const example = exampleOf(keys, fault);
  const link = example?.link ?? linkOf(keys.get('link'), fault);
  /** The section, or, where it has none, what the example says. */
  const asked = (name: string, said: string | undefined): Prose => {
    const own = part(name);
    return own.length > 0 || said === undefined ? own : proseOf(tokensOf(said), fault);
  };
  const free = freeOf(keys.get('free'), link, fault);
  const guess = guessOf(keys.get('guess'), free, link, fault);
  const hide = keys.get('hide') ?? 'no';
  if (!/^(yes|no)$/.test(hide)) fault(`hide is yes or no, got ${quote(hide)}`);
  const step: Step = {
    title: section.title.slice(0, LONGEST_TITLE),
    link,
    part: shownPart(keys.get('part'), link, fault),
    free,
    // An example's question has no field of its own.
    guess: guess ?? (example ? { type: 'open' } : null),
    // A link with hidden results counts as `hide`.
    hide: hide === 'yes' || decode(link).revealed !== null,
    text: proseOf(given ? rest : (body?.tokens ?? []), fault),
    question: asked('question', example?.asks),
    answer: asked('answer', example?.answer),
    notes: part('notes'),
    source: `## ${section.title}\n\n${sourceOf(section.tokens)}`,
  };
  for (const name of unknownIn(step)) fault(`${quote(`{${name}}`)} is no number that it shows`);
  return step;
}

/** Live numbers that Explore does not have; those of other pages cannot be checked here. */
function unknownIn({ link, text, question, answer, notes }: Step): string[] {
  const state = decode(link);
  const names = quantitiesIn([...text, ...question, ...answer, ...notes]);
  if (state.page !== 'explore' || names.length === 0) return [];
  const model = createDerive()({ ...state, revealed: null });
  return names.filter((name) => name !== 'slider' && !isQuantityOf(model, name));
}

/** A line "key: value". */
const PAIR = /^([a-z]+):[ \t]*(.*)$/;
const isPairs = (text: string): boolean =>
  text
    .trim()
    .split('\n')
    .every((line) => PAIR.test(line));

function pairsOf(text: string): Map<string, string> {
  const pairs = text.split('\n').flatMap((line): [string, string][] => {
    const [, key, value = ''] = line.match(PAIR) ?? [];
    return key ? [[key, value.trim()]] : [];
  });
  return new Map(pairs);
}

/** The link from its hash on, since a whole address may be given. */
function linkOf(text: string | undefined, fault: Fault): string {
  const hash = text?.match(/#\/.*$/)?.[0];
  if (!hash) {
    fault(text ? `${quote(text)} is no link of Graze` : 'it has no link');
    return '#/explore';
  }
  const { page, problems } = decode(hash);
  for (const words of problems) fault(words);
  if (page !== 'lesson') return hash;
  fault('a step cannot be a lesson');
  return '#/explore';
}

function shownPart(text: string | undefined, link: string, fault: Fault): string | null {
  if (!text) return null;
  const { page } = decode(link);
  const parts = partsOf(page);
  if (parts.includes(text)) return text;
  const has = parts.length > 0 ? `has ${parts.join(', ')}` : 'is shown as a whole';
  fault(`there is no part ${quote(text)}: ${page} ${has}`);
  return null;
}

function freeOf(text: string | undefined, link: string, fault: Fault): string | null {
  if (!text) return null;
  const state = decode(link);
  if (state.page === 'explore' && freedomOf(text, state)) return text;
  fault(`${quote(text)} cannot be free there`);
  return null;
}

/** The example of the gallery that a step shows, in place of a link. */
function exampleOf(keys: ReadonlyMap<string, string>, fault: Fault): Example | undefined {
  const id = keys.get('example');
  if (!id) return undefined;
  const found = GALLERY.find((one) => one.id === id);
  if (!found) fault(`there is no example ${quote(id)}`);
  if (keys.has('link')) fault('it has an example and a link: the example counts');
  return found;
}

/**
 * Reads a guess: "t1", "class", the value of the free number, "r = 1", what Explore asks, "sign",
 * or "open".
 */
function guessOf(
  text: string | undefined,
  free: string | null,
  link: string,
  fault: Fault,
): Guess | null {
  if (!text) return null;
  if (text === 'open') return { type: 'open' };
  const ask = CHOSEN_ASKS.find((one) => one === text);
  if (ask) {
    const state = decode(link);
    const shape = shapeOf(state);
    const isCurved = definitionOf(shape).formula(shape).family === 'curved';
    if (state.page === 'explore' && questionOf(ask, isCurved).id === ask) {
      return { type: 'prediction', ask };
    }
    fault(`${quote(text)} cannot be predicted there`);
    return null;
  }
  if (/^([\w-]+\.)?class$/.test(text)) return { type: 'class', quantity: text };
  const [, letter, value = ''] = text.match(/^(\S+) = (.+)$/) ?? [];
  if (letter === undefined && isQuantity(text)) return { type: 'quantity', quantity: text };
  const parsed = parseNumber(value);
  if (letter !== undefined && letter === free && parsed.ok) {
    return { type: 'free', truth: parsed.value };
  }
  fault(
    `${quote(text)} cannot be guessed: "class", "t1", "points", "open", or "r = 1" where r is free`,
  );
  return null;
}
