import { html, render } from 'lit';
import { readAll, type Texts } from '../../check/grade.ts';
import { checkOwn, type OwnReport, ownFields } from '../../check/own-numbers.ts';
import type { Input } from '../../check/types.ts';
import { ownNumbers } from '../../panels/check-own.ts';
import { controls } from '../../panels/controls.ts';
import { shapePicker } from '../../panels/shape-picker.ts';
import { createDerive } from '../../state/derive.ts';
import { exploreDetails } from '../../state/explore-details.ts';
import { type AppState, rayOf, shapeOf } from '../../state/state.ts';
import { typedValues } from '../../state/typed-values.ts';
import type { LeftPart, PartContext } from './page-parts.ts';

/** A student's own derivation for the ray and shape of the link, which are Explore's. */
export function createOwn({ storage, dispatch, changed }: PartContext): LeftPart {
  const derive = createDerive(() => exploreDetails);
  let texts: Texts = storage.own();
  let input: Input | null = null;
  let typed: AppState['typed'] | null = null;
  let report: OwnReport | null = null;
  const put = (next: Texts): void => {
    texts = next;
    report = null;
    storage.keepOwn(texts);
    changed();
  };
  /** The input, the same object while its numbers are the same; a new one clears the report. */
  const inputOf = (state: AppState): Input => {
    const next = { shape: shapeOf(state), ray: rayOf(state) };
    if (input && sameInput(input, next) && typed === state.typed) return input;
    report = null;
    typed = state.typed;
    input = { ...next, typed: typedValues({ ...state, shape: next.shape, texts: typed }) };
    return input;
  };
  return {
    render(head, body, state) {
      const model = derive(state);
      const now = inputOf(state);
      render(
        html`<h2>Own numbers</h2>
          <div class="own-picker">${shapePicker(model, dispatch)}</div>
          ${controls(model, dispatch, null)}`,
        head,
      );
      const tools = {
        type: (field: string, text: string) => put({ ...texts, [field]: text }),
        check() {
          report = checkOwn(now, texts);
          changed();
        },
        clear: () => put({}),
      };
      render(ownNumbers({ input: now, texts, report }, tools), body);
      const answers = report ? readAll(ownFields(now), texts) : null;
      return { input: now, results: report !== null, answers, given: {}, note: '' };
    },
  };
}

const sameInput = (a: Input, b: Input): boolean =>
  a.shape === b.shape &&
  a.ray.origin.every((x, i) => Object.is(x, b.ray.origin[i])) &&
  a.ray.direction.every((x, i) => Object.is(x, b.ray.direction[i]));
