import { html, nothing, type TemplateResult } from 'lit';
import type { Lesson, Step } from '../../lesson/lesson.ts';
import { lettersIn, quantitiesIn } from '../../lesson/prose.ts';
import { innerState } from '../../lesson/step-state.ts';
import { createDerive, type FullModel } from '../../state/derive.ts';
import { exploreDetails } from '../../state/explore-details.ts';
import type { AppState, Settings } from '../../state/state.ts';
import { exploreValue } from '../lesson/prose-tools.ts';
import { type ProseTools, proseView, type ShownValue } from '../lesson/prose-view.ts';
import { drawScene, graphOf, linkHead, sceneFrame } from './parts.ts';
import type { Handout } from './print.ts';

/** A snapshot of a page other than Explore: the live numbers of a step, and the page's element. */
export interface SeenPage {
  readonly values: ReadonlyMap<string, ShownValue>;
  readonly picture: Element;
}

interface LessonPaper {
  readonly lesson: Lesson;
  /** The link of the lesson's first step. */
  readonly link: string;
  readonly seen: (step: Step) => SeenPage | null;
  /** The settings after the step's question has been answered. */
  readonly answered: (step: Step) => Settings;
}

const SCENE = { width: 330, height: 164 };
const GRAPH = { width: 330, height: 100 };

/** Every step of a lesson with its drawing and its answer, one below the other. */
export function lessonHandout({ lesson, link, seen, answered }: LessonPaper): Handout {
  const drawings: ((root: HTMLElement) => void)[] = [];
  const derive = createDerive(() => exploreDetails);
  const steps = lesson.steps.map((step, i) => {
    const name = `step-${i + 1}`;
    const inner = innerState(step, { shown: '1' });
    const page = inner.page === 'explore' ? null : seen(step);
    const model = inner.page === 'explore' ? derive(inner) : null;
    const after = model && answerModel(step, answered(step), derive);
    drawings.push((root) => {
      if (model) drawScene(root, name, sceneFor(step, model), SCENE);
      else if (page) root.querySelector(`[data-page-of="${i + 1}"]`)?.append(page.picture);
    });
    return stepView(step, i + 1, toolsOf(model, page), toolsOf(after, page), {
      drawing: model ? html`${sceneFrame(name)}${graphOf(model, name, GRAPH)}` : null,
      missing: model === null && page === null,
    });
  });
  return {
    content: html`<article class="handout-lesson">
      ${linkHead(
        html`<h1>${lesson.title}</h1><p class="handout-caption">${lesson.about}</p>`,
        link,
      )}
      ${steps}
    </article>`,
    drawn: (root) => {
      for (const draw of drawings) draw(root);
    },
  };
}

/** All live numbers of a step. */
export const numbersOf = ({ text, question, answer }: Step): string[] =>
  quantitiesIn([...text, ...question, ...answer]);

function answerModel(
  step: Step,
  settings: Settings,
  derive: (state: AppState) => FullModel,
): FullModel {
  return derive(innerState(step, settings));
}

/** As beside the text on the page: normals where it speaks of them. */
function sceneFor(step: Step, { scene }: FullModel): FullModel['scene'] {
  const letters = lettersIn([...step.text, ...step.question, ...step.answer]);
  if (letters.has('N')) return scene;
  return { ...scene, hits: scene.hits.map((hit) => ({ ...hit, normal: null })) };
}

const toolsOf = (model: FullModel | null, page: SeenPage | null): ProseTools => ({
  model,
  slider: () => nothing,
  isHidden: () => false,
  room: (_, digits) => digits,
  value: (name) => (model ? exploreValue(model, name) : (page?.values.get(name) ?? null)),
});

function stepView(
  { title, text, question, answer, guess }: Step,
  number: number,
  tools: ProseTools,
  after: ProseTools,
  { drawing, missing }: { readonly drawing: TemplateResult | null; readonly missing: boolean },
): TemplateResult {
  const words = html`<div class="handout-text">
    <h2>${number} <span>${title}</span></h2>
    ${proseView(text, tools)}
    ${
      missing
        ? html`<p class="handout-missing">Step ${number} has not been shown on this device
      since the page was opened: its picture and its numbers are missing here.</p>`
        : nothing
    }
    ${
      guess
        ? html`<div class="handout-question">${proseView(question, tools)}</div>
      <div class="handout-answer"><h3>Answer</h3>${proseView(answer, after)}</div>`
        : nothing
    }
  </div>`;
  return drawing
    ? html`<section class="handout-step">
        <div class="handout-drawing">${drawing}</div>${words}</section>`
    : html`<section class="handout-step of-page">${words}
        <div class="handout-page" data-page-of=${number}></div></section>`;
}
