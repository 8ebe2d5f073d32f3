import type { Vec3 } from '../../math/index.ts';
import { AXES, definitionOf } from '../../math/shapes.ts';
import { display, displayTriple, shortest } from '../../text/format.ts';
import { askedOf, capital, givenName } from '../asked.ts';
import type { Posed } from '../compose.ts';
import { FOUR_DIGITS } from '../grade.ts';
import { plan, question } from '../session.ts';
import { solutionOf } from '../solution.ts';
import type { Answer, Field } from '../types.ts';

/** A wrong answer that a known mistake gives, and words on it. */
interface Wrong {
  /** Id of the misconception. */
  readonly id: string;
  readonly answer: number | string;
  readonly says: string;
}

/**
 * What course systems ask: one number, or one choice. A point is asked for by components, a
 * direction by those of its unit vector.
 */
export interface Part {
  /** Unique in a set: q3-t1. */
  readonly id: string;
  readonly title: string;
  /** Plain text, a sentence or the given values a line. */
  readonly prompt: string;
  readonly answer: number | string;
  /** Of a number, absolute. */
  readonly tolerance: number;
  /** Of a choice; empty for a number. */
  readonly options: readonly { readonly id: string; readonly title: string }[];
  readonly wrong: readonly Wrong[];
  /** The reason of the solution and the answer. */
  readonly solution: string;
  readonly posed: Posed;
  readonly field: string;
}

/** Significant digits in which numbers are given. */
const DIGITS = 8;

const shown = (answer: Answer): string =>
  typeof answer === 'number'
    ? display(answer, DIGITS)
    : typeof answer === 'object'
      ? displayTriple(answer, DIGITS)
      : answer;

/** The question's text: what is asked, ray and shape, and what is given beside. */
function promptOf(posed: Posed): string {
  const { exercise, draft, given } = posed;
  const { input, unknown, subject, told, described } = askedOf(posed);
  const { params } = definitionOf(draft.shape);
  const numbers = draft.shape as unknown as Readonly<Record<string, Answer>>;
  const shape = params.map(({ symbol, key }) => {
    const name = symbol === 'axis' ? 'normal along' : `${symbol} =`;
    return `${name} ${key === unknown ? '?' : shown(numbers[key] ?? '')}`;
  });
  const { origin, direction } = draft.ray;
  const known = Object.entries(given).map(([id, x]) => `${givenName(id)} = ${shown(x)}`);
  return [
    exercise.ask(draft),
    ...(input === 'all'
      ? [`Ray R(t) = E + t d: E = ${shown(origin)}, d = ${shown(direction)}`]
      : []),
    ...(input === 'all' ? [`${capital(subject)}: ${shape.join(', ')}`] : []),
    ...(input === 'E' ? [`E = ${shown(origin)}`] : []),
    ...(described ? [described] : []),
    ...told.map(({ name, says }) => `${name}: ${says}`),
    ...(known.length > 0 ? [`Given: ${known.join(', ')}`] : []),
  ].join('\n');
}

/** All parts of a set's session, in the order of its questions. */
export const partsOfSet = (seed: number, set: string): Part[] =>
  plan(seed, set).flatMap((_, i) => partsOfQuestion(question(seed, i, set), i + 1));

interface Component {
  readonly id: string;
  readonly label: string;
  of(answer: Answer | undefined): number | string | undefined;
}

function componentsOf({ id, kind, label }: Field): Component[] {
  const component = (x: Answer | undefined, k: number, unit: boolean): number | undefined => {
    if (typeof x !== 'object') return undefined;
    return unit ? unitOf(x)[k] : x[k];
  };
  if (kind === 'triple' || kind === 'direction') {
    const unit = kind === 'direction';
    return AXES.map((axis, k) => ({
      id: `${id}${axis}`,
      label: unit ? `${axis} of ${label} / |${label}|` : `${axis} of ${label}`,
      of: (x) => component(x, k, unit),
    }));
  }
  return [{ id, label, of: (x) => (typeof x === 'object' ? undefined : x) }];
}

const unitOf = (v: Vec3): Vec3 => {
  const length = Math.hypot(...v);
  return [v[0] / length, v[1] / length, v[2] / length];
};

const toleranceOf = (x: number): number => FOUR_DIGITS * (x === 0 ? 1 : Math.abs(x));

function partsOfQuestion(posed: Posed, number: number): Part[] {
  const { exercise, fields, truth, suspects } = posed;
  const prompt = promptOf(posed);
  return fields.flatMap((field) =>
    componentsOf(field).flatMap(({ id, label, of }): Part[] => {
      const answer = of(truth[field.id]);
      // Whether a number exists is asked by the choice beside it.
      if (answer === undefined || Number.isNaN(answer)) return [];
      const tolerance = typeof answer === 'number' ? toleranceOf(answer) : 0;
      const told: (number | string)[] = [answer];
      const wrong = suspects.flatMap(({ misconception, answers }): Wrong[] => {
        const other = of(answers[field.id]);
        if (other === undefined || !isUsable(other)) return [];
        if (told.some((one) => near(one, other))) return [];
        told.push(other);
        const { says, remedy } = misconception;
        const words = `This is what comes out with ${says}. ${remedy}`;
        return [{ id: misconception.id, answer: other, says: words }];
      });
      const ask = typeof answer === 'number' ? `${label} = ?` : `${label} …`;
      const named = fields.length > 1 || id !== field.id;
      return [
        {
          id: `q${number}-${id.replace(/\W/g, '')}`,
          title: `Question ${number}, ${exercise.topic}${named ? `: ${label}` : ''}`,
          prompt: `${prompt}\n${ask}`,
          ...{ answer, tolerance, options: field.options, wrong, posed, field: id },
          solution: [...solutionOf(posed).decision, solved(field, label, answer)].join('\n'),
        },
      ];
    }),
  );
}

const isUsable = (x: number | string): boolean => typeof x === 'string' || Number.isFinite(x);

/** Whether two answers could both be accepted for one value. */
function near(a: number | string, b: number | string): boolean {
  if (typeof a === 'string' || typeof b === 'string') return a === b;
  return Math.abs(a - b) <= toleranceOf(a) + toleranceOf(b);
}

function solved(field: Field, label: string, answer: number | string): string {
  if (typeof answer === 'number') return `${label} = ${display(answer, DIGITS)}`;
  const title = field.options.find(({ id }) => id === answer)?.title ?? answer;
  return `${label}: ${title}`;
}

/** A number as course systems read it: digits, point, e. */
export const plainNumber = (x: number): string => shortest(x);
