import { csv } from '../text/csv.ts';
import { derivationFor } from './compose.ts';
import { findExercise } from './exercises/index.ts';
import { readAnswer } from './grade.ts';
import { judge } from './judge.ts';
import { findMisconception } from './misconceptions/index.ts';
import type { Asked } from './progress.ts';
import { plan, question, studentSeed } from './session.ts';
import { setProblem } from './sets.ts';

/** What a student hands in: the questions by set, seed and name, and what was done with each. */
export interface HandIn {
  readonly set: string;
  /** The seed of all; the student's own follows from it and the name. */
  readonly seed: number;
  /** Name or number; '' if none was given. */
  readonly who: string;
  readonly asked: readonly Asked[];
}

/** A question of a hand-in, marked anew from its texts. */
interface MarkedQuestion {
  readonly exercise: string;
  readonly topic: string;
  readonly kind: string;
  readonly answered: boolean;
  /** Right, and before the solution was read. */
  readonly right: boolean;
  readonly tries: number;
  readonly hints: number;
  readonly solutionShown: boolean;
  /** Ids of misconceptions: named on the way, or behind the texts as they are. */
  readonly causes: readonly string[];
}

export interface MarkedStudent {
  readonly who: string;
  readonly set: string;
  readonly seed: number;
  readonly right: number;
  readonly questions: readonly MarkedQuestion[];
  /** Sentences on what is unusual about this hand-in. */
  readonly notes: readonly string[];
}

/** A step of the marking: a question at a time, since posing one may take some 50 ms. */
type Marking = Generator<void, MarkedStudent>;

/** Marks a hand-in; each `next` marks a question. */
export function* marking({ set, seed, who, asked }: HandIn): Marking {
  const own = studentSeed(seed, who);
  const slots = setProblem(set) === '' ? plan(own, set) : [];
  const questions: MarkedQuestion[] = [];
  const notes = slots.length === 0 ? [`its set is not known here: ${setProblem(set)}`] : [];
  for (const [index, { exercise, kind }] of slots.entries()) {
    const one = asked[index];
    const topic = findExercise(exercise)?.topic ?? exercise;
    const about = { exercise, topic, kind };
    questions.push(one ? { ...about, ...marked(own, index, set, one) } : { ...about, ...OPEN });
    yield;
  }
  return {
    ...{ who, set, seed, questions, notes },
    right: questions.filter(({ right }) => right).length,
  };
}

type Marks = Omit<MarkedQuestion, 'exercise' | 'topic' | 'kind'>;

const OPEN: Marks = {
  answered: false,
  right: false,
  tries: 0,
  hints: 0,
  solutionShown: false,
  causes: [],
};

function marked(seed: number, index: number, set: string, asked: Asked): Marks {
  const { texts, tries, hints, solutionShown, solvedAt } = asked;
  const posed = question(seed, index, set);
  const judged = judge(derivationFor(posed), texts);
  const read = solutionShown && solvedAt === null;
  const found = judged.verdict === 'wrong' ? judged.causes.map(({ id }) => id) : [];
  const known = asked.causes.filter((id) => findMisconception(id));
  return {
    answered: posed.fields.some((field) => {
      const text = texts[field.id] ?? '';
      return text.trim() !== '' && readAnswer(field, text).ok;
    }),
    right: judged.verdict === 'correct' && !read,
    ...{ tries, hints, solutionShown },
    causes: [...new Set([...known, ...found])],
  };
}

interface Share {
  readonly name: string;
  readonly count: number;
  readonly of: number;
}

export interface ClassReport {
  readonly students: readonly MarkedStudent[];
  /** How many of the questions on a topic were right, hardest first. */
  readonly topics: readonly Share[];
  /** How many of the students made a mistake, the commonest first. */
  readonly misconceptions: readonly Share[];
}

/** What is usual in this class: the set and the seed, if they are known. */
interface Expected {
  readonly set: string;
  readonly seed: number;
}

/** The class by student, topic and misconception. */
export function classReport(
  marked: readonly MarkedStudent[],
  expected: Expected | null = null,
): ClassReport {
  const students = marked
    .map((one) => ({ ...one, notes: [...one.notes, ...remarksOn(one, marked, expected)] }))
    .sort((a, b) => a.who.localeCompare(b.who, 'en', { numeric: true }));
  const topics = new Map<string, { right: number; all: number }>();
  const causes = new Map<string, number>();
  for (const { questions } of students) {
    for (const { topic, right } of questions) {
      const now = topics.get(topic) ?? { right: 0, all: 0 };
      topics.set(topic, { right: now.right + (right ? 1 : 0), all: now.all + 1 });
    }
    const made = new Set(questions.flatMap((one) => one.causes));
    for (const id of made) causes.set(id, (causes.get(id) ?? 0) + 1);
  }
  return {
    students,
    topics: [...topics]
      .map(([name, { right, all }]) => ({ name, count: right, of: all }))
      .sort((a, b) => a.count / a.of - b.count / b.of),
    misconceptions: [...causes]
      .map(([id, count]) => ({
        name: findMisconception(id)?.says ?? id,
        count,
        of: students.length,
      }))
      .sort((a, b) => b.count - a.count),
  };
}

function remarksOn(
  one: MarkedStudent,
  all: readonly MarkedStudent[],
  expected: Expected | null,
): string[] {
  const same = all.filter(({ who }) => who !== '' && who === one.who).length;
  return [
    one.who === '' ? 'no name' : '',
    same > 1 ? `handed in ${same} times` : '',
    expected && one.set !== expected.set ? `another set: ${one.set}` : '',
    expected && one.seed !== expected.seed ? `another seed: ${one.seed}` : '',
  ].filter((words) => words !== '');
}

/** A line for each student; a column for each question, by number: 1 if it is right. */
export function classCsv({ students }: ClassReport): string {
  const most = Math.max(0, ...students.map(({ questions }) => questions.length));
  const numbers = Array.from({ length: most }, (_, i) => `q${i + 1}`);
  const head = ['who', 'set', 'seed', 'right', 'asked', 'tries', 'hints', 'solutions read'];
  return csv([
    [...head, 'misconceptions', 'notes', ...numbers],
    ...students.map(({ who, set, seed, right, questions, notes }) => [
      ...[who, set, seed, right, questions.length],
      questions.reduce((sum, { tries }) => sum + tries, 0),
      questions.reduce((sum, { hints }) => sum + hints, 0),
      questions.filter(({ solutionShown }) => solutionShown).length,
      [...new Set(questions.flatMap(({ causes }) => causes))].join(' '),
      notes.join('; '),
      ...numbers.map((_, i) => (questions[i] ? (questions[i].right ? 1 : 0) : '')),
    ]),
  ]);
}
