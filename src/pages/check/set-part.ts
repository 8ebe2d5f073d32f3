import { html, render } from 'lit';
import { EXERCISES } from '../../check/exercises/index.ts';
import { gift } from '../../check/exports/gift.ts';
import { moodleXml } from '../../check/exports/moodle.ts';
import { type Part, partsOfSet } from '../../check/exports/parts.ts';
import { qtiFiles } from '../../check/exports/qti.ts';
import { stackXml } from '../../check/exports/stack.ts';
import {
  type Chosen,
  isNumbered,
  partsOf,
  setId,
  setName,
  setOf,
  setProblem,
} from '../../check/sets.ts';
import { SHAPES } from '../../math/index.ts';
import type { ShapeKind } from '../../math/shapes.ts';
import {
  type CourseFile,
  type Packages,
  type SetTools,
  type SetView,
  type Sheets,
  setForm,
} from '../../panels/check-set.ts';
import type { Course } from '../../state/course/course.ts';
import { pageWithCourse } from '../../state/course/package.ts';
import { COURSE_SYSTEMS } from '../../state/course/systems.ts';
import { zipLater, zipOf } from '../../state/zip.ts';
import { parseNumber } from '../../text/parse.ts';
import { quoted } from '../../text/refusal.ts';
import { copyText } from '../../ui/clipboard.ts';
import { download } from '../../ui/files.ts';
import { printPage, printsAs } from '../handout/print.ts';
import { MOST_SHEETS, type Sheet, seedsOf, sheetOf, sheetsHandout } from '../handout/sheets.ts';
import { ownFile } from './own-file.ts';
import type { PartContext, WidePart } from './page-parts.ts';
import { activityOf, setLink } from './set-link.ts';
import { type CheckSettings, seedProblem } from './settings.ts';

/** The contents of the form for a set. */
interface Form {
  readonly times: ReadonlyMap<string, number>;
  readonly shapes: readonly ShapeKind[];
  readonly level: string;
  readonly hints: boolean;
}

function madeOf(id: string): Form {
  const { turns, shapes, level, withoutHints } = setOf(id);
  const newest = new Set(EXERCISES.map((one) => one.id));
  const times = new Map<string, number>();
  for (const { exercise, times: count } of turns) {
    // The form offers the newest versions; a set of its own keeps those that it names.
    const base = exercise.replace(/\.\d+$/, '');
    const own = isNumbered(id)
      ? [...newest].find((one) => one.replace(/\.\d+$/, '') === base)
      : exercise;
    times.set(own ?? exercise, (times.get(own ?? exercise) ?? 0) + count);
  }
  return { times, shapes, level: level === undefined ? '' : String(level), hints: !withoutHints };
}

/** The id of the form's set, with shapes in the order of SHAPES: equal sets have equal ids. */
function idOf({ times, shapes, level, hints }: Form): string {
  const items = [...times].filter(([, count]) => count > 0);
  const base = items.map(([id, count]) => (count === 1 ? id : `${id}*${count}`)).join(',');
  const kinds = SHAPES.map(({ kind }) => kind).filter((kind) => shapes.includes(kind));
  const chosen: Chosen = {
    shapes: kinds.join(','),
    ...(level ? { level } : {}),
    ...(hints ? {} : { hints: 'off' }),
  };
  return setId(base, chosen);
}

/** The input of the functions that make files. */
interface FileInput {
  readonly parts: () => readonly Part[];
  /** The set and its seed in words. */
  readonly about: string;
  /** The link of its questions, from # on. */
  readonly hash: string;
  /** The course of a package for this system. */
  readonly course: (system: string) => Course;
}

interface FileKind extends CourseFile {
  readonly name: string;
  readonly type: string;
  readonly content: (made: FileInput) => BlobPart | Promise<BlobPart>;
}

const FILES: readonly FileKind[] = [
  {
    id: 'moodle',
    title: 'Moodle XML',
    says:
      'Numerical and multiple choice questions for Moodle’s question bank: text, right answer, ' +
      'worked reason, and for each known mistake its wrong answer with what to look at again.',
    name: 'graze-moodle.xml',
    type: 'application/xml',
    content: ({ parts, about }) => moodleXml(parts(), about),
  },
  {
    id: 'gift',
    title: 'GIFT',
    says: 'The same as plain text, which Moodle and others read.',
    name: 'graze.gift.txt',
    type: 'text/plain',
    content: ({ parts }) => gift(parts()),
  },
  {
    id: 'qti',
    title: 'QTI 2.1',
    says: 'The same as a package (zip) of the IMS standard, for other course systems.',
    name: 'graze-qti.zip',
    type: 'application/zip',
    content: ({ parts }) => zipOf(qtiFiles(parts())) as BlobPart,
  },
  {
    id: 'stack',
    title: 'STACK',
    says:
      'Of the questions on A, B, C, D and two roots: Moodle XML for STACK, in which Maxima ' +
      'computes the answer and each mistake from its formula, a node each of the response tree.',
    name: 'graze-stack.xml',
    type: 'application/xml',
    content: ({ parts, about }) => stackXml(parts(), about),
  },
  ...COURSE_SYSTEMS.map(
    ({ id, title, says, manifest }): FileKind => ({
      ...{ id, title, says, name: `graze-${id}.zip`, type: 'application/zip' },
      async content({ course, hash }) {
        const own = course(id);
        const page = pageWithCourse(await ownFile(), own, hash);
        const files = { [manifest.name]: manifest.write(own), 'index.html': page };
        return (await zipLater(files)) as BlobPart;
      },
    }),
  ),
];

/** The part 'Make a set'; the link holds the whole set. */
export function createSetPart({ set, changed, say }: PartContext): WidePart {
  let refusals: Record<string, string> = {};
  /** Stores the refusal of a box, '' for none; returns whether its text is accepted. */
  const accepts = (box: string, problem: string): boolean => {
    refusals = { ...refusals, [box]: problem };
    return problem === '';
  };
  let packages: Packages = { pass: 50, own: true };
  /** Words on the file that is being made; '' for none. */
  let saving = '';
  let sheets: Sheets = { from: 1, to: 1, paper: 'a4', key: true };
  let making: SetView['making'] = null;
  let made: { readonly set: string; readonly sheets: readonly Sheet[] } = { set: '', sheets: [] };
  let host: HTMLElement | null = null;
  const sheetsOf = (seed: number): void => {
    sheets = { ...sheets, from: seed, to: seed };
    for (const end of ['from', 'to']) accepts(end, '');
  };
  const isShown = (): boolean => host?.isConnected === true && host.closest('[hidden]') === null;
  /** The sheet of a seed; what was made before is kept while the set is the same. */
  const sheetFor = (set: string, seed: number): Sheet => {
    const known = made.set === set ? made.sheets.find((one) => one.seed === seed) : undefined;
    const sheet = known ?? sheetOf(set, seed);
    if (!known) made = { set, sheets: [...(made.set === set ? made.sheets : []), sheet] };
    return sheet;
  };
  const prepare = async (): Promise<boolean> => {
    if (!now) return false;
    const { set } = now;
    const seeds = seedsOf(sheets);
    for (const [i, seed] of seeds.entries()) {
      making = { done: i + 1, total: seeds.length };
      changed();
      sheetFor(set, seed);
      await new Promise((resolve) => setTimeout(resolve));
    }
    making = null;
    changed();
    return now.set === set && isShown();
  };
  printsAs(() => {
    if (!now || !isShown()) return null;
    const { set } = now;
    const all = seedsOf(sheets).map((seed) => sheetFor(set, seed));
    return sheetsHandout(set, all, sheets);
  }, prepare);
  let now: CheckSettings | null = null;
  let link = '';
  const put = (box: string, change: Partial<Form>): void => {
    if (!now) return;
    const form = { ...madeOf(now.set), ...change };
    const id = idOf(form);
    if (accepts(box, formProblem(id, form))) {
      set({ set: id, question: 0 });
      // Another change may come before the page is drawn with this one.
      now = { ...now, set: id };
    }
    changed();
  };
  const tools: SetTools = {
    times(exercise, text) {
      if (!now) return;
      const count = /^\d{1,3}$/.test(text) ? Number(text) : null;
      if (count === null) {
        accepts(exercise, `${quoted(text)} does not say how often: a whole number from 0 on does.`);
        changed();
      } else put(exercise, { times: new Map([...madeOf(now.set).times, [exercise, count]]) });
    },
    shape(kind, wanted) {
      if (!now) return;
      const { shapes } = madeOf(now.set);
      put('shapes', { shapes: wanted ? [...shapes, kind] : shapes.filter((one) => one !== kind) });
    },
    level: (level) => put('beside', { level }),
    hints: (hints) => put('beside', { hints }),
    seed(text) {
      if (accepts('seed', seedProblem('seed', text))) set({ seed: Number(text) });
      changed();
    },
    async copy() {
      const copied = await copyText(link);
      say(copied ? 'copied: the link of the set' : 'it could not be copied: mark it and copy it');
    },
    async save(id) {
      const file = FILES.find((one) => one.id === id);
      if (!now || !file || saving) return;
      const { set: own, seed } = now;
      saving = `${file.title} is put together …`;
      accepts('file', '');
      changed();
      try {
        const content = await file.content({
          parts: () => partsOfSet(seed, own),
          about: `Graze/${setName(own)}, seed ${seed}`,
          hash: setLink(own, seed),
          course: (system) => ({
            system,
            set: own,
            seed,
            ...packages,
            activity: activityOf(setLink(own, seed)),
          }),
        });
        download(file.name, new Blob([content], { type: file.type }));
        saving = '';
        say(`saved: ${file.name}`);
      } catch (error) {
        if (!(error instanceof RangeError)) throw error;
        const words = `it needs Graze as one file: ${error.message}`;
        accepts('file', `${file.title} was not saved, for ${words}.`);
      } finally {
        saving = '';
        changed();
      }
    },
    own(own) {
      packages = { ...packages, own };
      changed();
    },
    pass(text) {
      const read = parseNumber(text);
      const isPercent = read.ok && read.value >= 0 && read.value <= 100;
      const reason = read.ok ? `${quoted(text)} is not from 0 to 100` : read.reason;
      if (accepts('pass', isPercent ? '' : `Passed from: ${reason}.`) && read.ok) {
        packages = { ...packages, pass: read.value };
      }
      changed();
    },
    sheets(change) {
      sheets = { ...sheets, ...change };
      changed();
    },
    sheetSeed(end, text) {
      const seed = Number(text);
      const wanted: Sheets = { ...sheets, [end]: seed };
      const { from, to } = wanted;
      const many =
        to - from < MOST_SHEETS
          ? ''
          : `${quoted(text)} makes ${to - from + 1} sheets: up to ${MOST_SHEETS} at a time.`;
      if (accepts(end, seedProblem('seed', text) || many)) {
        // Beyond the other end it takes that one with it.
        if (to < from) sheetsOf(seed);
        else sheets = wanted;
      }
      changed();
    },
    print: () => void printPage(),
    open: () => set({ part: 'questions', question: 0 }),
  };
  return {
    render(own, settings) {
      host = own;
      const isOther = now?.seed !== settings.seed;
      if (isOther) accepts('seed', '');
      if (isOther && (!now || sheets.from === sheets.to)) sheetsOf(settings.seed);
      now = settings;
      link = `${location.href.split(/[?#]/)[0]}${setLink(settings.set, settings.seed)}`;
      const { times, shapes, level, hints } = madeOf(settings.set);
      const view: SetView = {
        times: Object.fromEntries(times),
        ...{ shapes, level, hints, seed: settings.seed, link, refusals },
        numbered: isNumbered(settings.set)
          ? { name: setName(settings.set), isSpread: setOf(settings.set).spread === true }
          : null,
        ...{ files: FILES, sheets, making, packages, saving },
        count: [...times.values()].reduce((sum, count) => sum + count, 0),
      };
      render(html`${setForm(view, tools)}`, own);
    },
  };
}

/** Why the form makes no set; '' if it does. */
function formProblem(id: string, { shapes }: Form): string {
  if (partsOf(id).base === '') return 'A set has at least one question.';
  // A text without shapes is that of a set about all of them.
  return shapes.length === 0 ? 'A set is about at least one shape.' : sentence(setProblem(id));
}

const sentence = (problem: string): string =>
  problem === '' ? '' : `${problem[0]?.toUpperCase()}${problem.slice(1)}.`;
