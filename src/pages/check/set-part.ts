import { html, render } from 'lit';
import { EXERCISES } from '../../check/exercises/index.ts';
import { CHOSEN, type Chosen, partsOf, setId, setOf, setProblem } from '../../check/sets.ts';
import { SHAPES } from '../../math/index.ts';
import type { ShapeKind } from '../../math/shapes.ts';
import { type SetTools, type SetView, setForm } from '../../panels/check-set.ts';
import { copyText } from '../../ui/clipboard.ts';
import type { PartContext, WidePart } from './part.ts';
import type { CheckSettings } from './settings.ts';

/** What the form says of a set, its own or a numbered one. */
interface Made {
  readonly times: ReadonlyMap<string, number>;
  readonly shapes: readonly ShapeKind[];
  readonly level: string;
  readonly hints: boolean;
}

function madeOf(id: string): Made {
  const { turns, shapes, level, withoutHints } = setOf(id);
  const newest = new Set(EXERCISES.map((one) => one.id));
  const times = new Map<string, number>();
  for (const { exercise, times: count } of turns) {
    // The form offers the newest versions; a set of its own keeps those that it names.
    const base = exercise.replace(/\.\d+$/, '');
    const own = /^\d/.test(id)
      ? [...newest].find((one) => one.replace(/\.\d+$/, '') === base)
      : exercise;
    times.set(own ?? exercise, (times.get(own ?? exercise) ?? 0) + count);
  }
  return { times, shapes, level: level === undefined ? '' : String(level), hints: !withoutHints };
}

/** The shapes' order decides nothing, but one text a set is easier to compare. */
function idOf({ times, shapes, level, hints }: Made): string {
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

/** Where a set is made; all of it is in the link. */
export function createSetPart({ set, changed, say }: PartContext): WidePart {
  let refusal = '';
  let now: CheckSettings | null = null;
  let link = '';
  const put = (change: Partial<Made>): void => {
    if (!now) return;
    const id = idOf({ ...madeOf(now.set), ...change });
    const empty = partsOf(id).base === '';
    refusal = empty ? 'A set has at least one question.' : words(setProblem(id));
    if (refusal === '') set({ set: id, question: 0 });
    changed();
  };
  const tools: SetTools = {
    times(exercise, count) {
      if (!now) return;
      if (!Number.isInteger(count) || count < 0) {
        refusal = 'How often is a whole number from 0 on.';
        changed();
        return;
      }
      put({ times: new Map([...madeOf(now.set).times, [exercise, count]]) });
    },
    shape(kind, wanted) {
      if (!now) return;
      const { shapes } = madeOf(now.set);
      put({ shapes: wanted ? [...shapes, kind] : shapes.filter((one) => one !== kind) });
    },
    level: (level) => put({ level }),
    hints: (hints) => put({ hints }),
    seed(seed) {
      if (Number.isSafeInteger(seed) && Math.abs(seed) < 1e9) {
        refusal = '';
        set({ seed });
      } else refusal = 'The seed is a whole number of up to nine digits.';
      changed();
    },
    async copy() {
      const copied = await copyText(link);
      say(copied ? 'copied: the link of the set' : 'it could not be copied: mark it and copy it');
    },
    open: () => set({ part: 'questions', question: 0 }),
  };
  return {
    render(host, settings) {
      now = settings;
      link = `${location.href.split(/[?#]/)[0]}${setLink(settings.set, settings.seed)}`;
      const { times, shapes, level, hints } = madeOf(settings.set);
      const view: SetView = {
        times: Object.fromEntries(times),
        ...{ shapes, level, hints, seed: settings.seed, link, refusal },
        count: [...times.values()].reduce((sum, count) => sum + count, 0),
      };
      render(html`${setForm(view, tools)}`, host);
    },
  };
}

const words = (problem: string): string =>
  problem === '' ? '' : `${problem[0]?.toUpperCase()}${problem.slice(1)}.`;

/** The link of a set's questions: of letters that links hold as they are. */
function setLink(set: string, seed: number): string {
  const { base, chosen } = partsOf(set);
  const pairs = [
    ['set', base],
    ...CHOSEN.flatMap((key) => (chosen[key] ? [[key, chosen[key]]] : [])),
    ['seed', String(seed)],
  ];
  return `#/check?${pairs.map(([key, text]) => `${key}=${text}`).join('&')}`;
}
