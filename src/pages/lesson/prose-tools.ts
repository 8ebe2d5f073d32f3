import type { nothing, TemplateResult } from 'lit';
import { isQuantity, quantityOf } from '../../lesson/quantities.ts';
import type { ExploreModel } from '../../state/derive.ts';
import type { ProseTools } from './prose-view.ts';
import type { Place } from './source.ts';

/** The longest text of each live number in the step that is shown. */
let rooms: { key: string; lengths: Map<string, number> } = { key: '', lengths: new Map() };

/** What of the prose follows the scene, or the page beside it. */
export function proseTools(
  { lesson, number }: Place,
  model: ExploreModel | null,
  page: HTMLElement,
  slider: () => TemplateResult | typeof nothing,
): ProseTools {
  const key = `${lesson.id} ${number}`;
  if (rooms.key !== key) rooms = { key, lengths: new Map() };
  return {
    model,
    slider,
    value: (name) => (model ? quantityOf(model, name) : valueOnPage(page, name)),
    isHidden: (name) => model !== null && !model.shown.hits && isResult(name, model),
    room(name, length) {
      const most = Math.max(length, rooms.lengths.get(name) ?? 0);
      rooms.lengths.set(name, most);
      return most;
    },
  };
}

/** Everything that follows from the ray and the shape, but the coefficients that lead to it. */
const isResult = (name: string, { derivation }: ExploreModel): boolean =>
  /^([tPN][12](\.|$)|class$|D$)/.test(name) ||
  (derivation.steps.some(({ id }) => id === name) && !/^[ABC]$/.test(name));

/** {textbook.t1} is the t1 of the row of textbook; {A} is the page's own A. */
function valueOnPage(page: HTMLElement, name: string): number | string | null {
  if (!isQuantity(name)) return null;
  const [row = '', ...rest] = name.split('.');
  const found =
    page.querySelector(`[data-quantity="${CSS.escape(name)}"]`) ??
    page.querySelector(
      `[data-method="${CSS.escape(row)}"] [data-quantity="${CSS.escape(rest.join('.'))}"]`,
    );
  const text = found?.getAttribute('data-value');
  if (text === null || text === undefined) return null;
  const number = Number(text);
  return text.trim() === '' || Number.isNaN(number) ? text : number;
}
