import type { nothing, TemplateResult } from 'lit';
import { isQuantity, quantityOf } from '../../lesson/quantities.ts';
import type { ExploreModel } from '../../state/derive.ts';
import { display } from '../../text/format.ts';
import type { LessonStep } from './lesson-step.ts';
import type { ProseTools, ShownValue } from './prose-view.ts';

/** The largest width in digits of each live number in the present step. */
let rooms: { key: string; lengths: Map<string, number> } = { key: '', lengths: new Map() };

/** What is shown beside the text: Explore's model, or an element with another page. */
interface Beside {
  readonly model: ExploreModel | null;
  readonly page: HTMLElement;
  /** The quantity that is asked, while the page is covered; null otherwise. */
  readonly asked: string | null;
}

/** The values for live numbers in the prose, from the scene or the page beside it. */
export function proseTools(
  { lesson, number }: LessonStep,
  { model, page, asked }: Beside,
  slider: () => TemplateResult | typeof nothing,
): ProseTools {
  const key = `${lesson.id} ${number}`;
  if (rooms.key !== key) rooms = { key, lengths: new Map() };
  return {
    model,
    slider,
    value: (name) => (model ? exploreValue(model, name) : valueOnPage(page, name)),
    isHidden: (name) =>
      model !== null ? !model.shown.hits && isResult(name, model) : name === asked,
    room(name, length) {
      const most = Math.max(length, rooms.lengths.get(name) ?? 0);
      rooms.lengths.set(name, most);
      return most;
    },
  };
}

/** Whether a quantity is a result, and not a coefficient A, B or C that leads to it. */
const isResult = (name: string, { derivation }: ExploreModel): boolean =>
  /^([tPN][12](\.|$)|class$|D$)/.test(name) ||
  (derivation.steps.some(({ id }) => id === name) && !/^[ABC]$/.test(name));

/** A number of Explore, as it is shown there. */
export function exploreValue(model: ExploreModel, name: string): ShownValue | null {
  const value = quantityOf(model, name);
  if (value === null) return null;
  return { value, text: typeof value === 'number' ? display(value) : value };
}

/** Longest text of a rounded number; a longer one shows all digits. */
const LONGEST_TEXT = 12;

/** Selector of an unfinished picture, whose counts of rays are not final. */
export const UNFINISHED = '[data-trace]:not([data-trace="finished"])';

/** The value of {questions} on the page, or of {textbook.t1} in the row of textbook. */
export function valueOnPage(page: HTMLElement, name: string): ShownValue | null {
  if (!isQuantity(name) || page.querySelector(UNFINISHED)) return null;
  const [row = '', ...rest] = name.split('.').map((part) => CSS.escape(part));
  const cell = `[data-quantity="${rest.join('.')}"]`;
  const found =
    page.querySelector(`[data-quantity="${CSS.escape(name)}"]`) ??
    page.querySelector(`:is([data-method="${row}"], [data-effect="${row}"]) ${cell}`);
  const full = found?.getAttribute('data-value');
  if (!found || full === null || full === undefined) return null;
  const number = Number(full);
  const own = (found.textContent ?? '').trim();
  if (full.trim() === '' || Number.isNaN(number)) return { value: full, text: own || full };
  // A count of 0 may be written in words.
  const isShort = own.length <= LONGEST_TEXT && /^[−\d]/.test(own);
  return { value: number, text: isShort ? own : display(number) };
}
