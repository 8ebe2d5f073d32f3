import { nothing, render } from 'lit';
import type { Step } from '../../lesson/lesson.ts';
import { partShown } from '../../lesson/parts.ts';
import { lettersIn, quantitiesIn } from '../../lesson/prose.ts';
import { isLesson } from '../../lesson/read.ts';
import { isHidden as areHidden, innerState, isAsked, toStep } from '../../lesson/step-state.ts';
import { writeLesson } from '../../lesson/write.ts';
import { announcement } from '../../state/announce.ts';
import { createDerive, type FullModel } from '../../state/derive.ts';
import { exploreDetails } from '../../state/explore-details.ts';
import type { AppState, Settings } from '../../state/state.ts';
import { encode } from '../../state/url.ts';
import { download, pickFile } from '../../ui/files.ts';
import { recall } from '../../ui/storage.ts';
import { wordsOf } from '../../ui/words-of.ts';
import { lessonHandout } from '../handout/lesson-handout.ts';
import { printPage, printsAs } from '../handout/print.ts';
import type { MountPage } from '../page.ts';
import { createTransition } from '../transition.ts';
import { createEditing } from './editing.ts';
import { mountExplorePart } from './explore-part.ts';
import { answerView, questionView } from './guess-view.ts';
import { createHandIn } from './hand-in.ts';
import { type LessonStep, lessonStepOf, readSettings } from './lesson-step.ts';
import { listView } from './list-view.ts';
import { createOtherPages } from './other-pages.ts';
import { openedLesson, withCollected } from './own-lesson.ts';
import { createPageSnapshots } from './page-snapshots.ts';
import { mountPresenter } from './presenter.ts';
import { type Projected, presenterIn } from './presenter-channel.ts';
import { OPENED, projectedWindow } from './projected-window.ts';
import { proseTools, valueOnPage } from './prose-tools.ts';
import { slidersOf } from './sliders.ts';
import { type StepParts, stepView } from './step-view.ts';
import './lesson-page.css';
import './lesson-text.css';

/** From one step to the next. */
const TRAVEL_MS = 400;

/** The settings of the first step of a lesson. */
const firstStep = ({ id, file }: Settings): Settings => ({
  ...(id === undefined ? {} : { id }),
  ...(file === undefined ? {} : { file }),
});

/** A step as it was drawn last. */
interface DrawnStep {
  readonly place: LessonStep;
  readonly inner: AppState;
  readonly model: FullModel | null;
  readonly asked: boolean;
}

/** The page Lessons: a text beside what it is about, step by step; without an id, the list. */
export const mountLesson: MountPage = (host, context) => {
  const { dispatch, changed, announce } = context;
  host.classList.add('lesson');
  const presenter = presenterIn(location.search);
  if (presenter) return mountPresenter(host, context, presenter);
  const area = (name: string): HTMLElement => {
    const element = document.createElement('div');
    element.className = `lesson-${name}`;
    host.append(element);
    return element;
  };
  const [list, stage, other] = [area('list'), area('stage'), area('other')];
  const [cover, text] = [area('cover'), area('column')];
  cover.textContent = 'Hidden. Predict first.';
  const handIn = createHandIn(dispatch, changed);
  const editing = createEditing(dispatch, changed);
  const derive = createDerive(() => exploreDetails);
  const travel = createTransition(TRAVEL_MS, changed);
  const projected = projectedWindow();
  let problem: ReturnType<typeof projected.open> = null;
  const present = (): void => {
    problem = projected.open();
    // A problem is announced where it is shown.
    if (!problem) announce(OPENED, 'deed');
    changed();
  };
  const others = createOtherPages(other, context, handIn.inner);
  let explore: ReturnType<typeof mountExplorePart> | null = null;
  let shown: DrawnStep | null = null;
  /** The model whose changes were announced last. */
  let heard: FullModel | null = null;
  let outer: AppState | null = null;
  let last: { readonly link: string; readonly state: AppState } | null = null;

  /** The step that is shown for paper alone, in place of the one that the state names. */
  let forPaper: Settings | null = null;
  const paper = createPageSnapshots(other, (settings) => {
    forPaper = settings;
    changed();
  });
  printsAs(
    () => {
      if (!shown || !host.isConnected || !outer) return null;
      const { lesson } = shown.place;
      const settings = firstStep(outer.settings.lesson);
      const stepped = (step: Step): Settings => ({
        ...settings,
        step: String(lesson.steps.indexOf(step) + 1),
      });
      return lessonHandout({
        lesson,
        link: encode({ ...outer, settings: { ...outer.settings, lesson: settings } }),
        seen: paper.seen,
        answered: (step) => handIn.answered(stepped(step)),
      });
    },
    async () =>
      !shown || !outer || paper.prepare(shown.place.lesson, firstStep(outer.settings.lesson)),
  );

  const go = (number: number): void => {
    const count = shown?.place.lesson.steps.length ?? 0;
    if (number < 1 || number > count) return;
    editing.cancel();
    dispatch({ type: 'settings', values: toStep(number) });
  };
  const collect = (link: string): void => {
    dispatch({ type: 'open', state: (now) => withCollected(now, link).state });
    announce('added as a step of your own lesson');
  };
  const openText = (given: string): boolean => {
    if (!outer || !isLesson(given)) return false;
    const opened = openedLesson(outer, given);
    dispatch({ type: 'open', state: opened });
    const { problems } = readSettings(opened.settings.lesson);
    if (problems.length > 0) dispatch({ type: 'say', problems });
    return true;
  };
  const openFile = async (): Promise<void> => {
    const given = await pickFile('.md,.txt,text/markdown,text/plain');
    if (given === null || openText(given) || !outer) return;
    dispatch({ type: 'say', problems: openedLesson(outer, given).problems });
  };
  const save = (): void => {
    if (!shown) return;
    const { lesson } = shown.place;
    download(`${lesson.id}.md`, writeLesson(lesson), 'text/markdown');
  };

  const showList = (state: AppState): void => {
    shown = null;
    others.leave();
    host.dataset.look = 'list';
    render(nothing, text);
    const own = listView({
      hasOwn: recall('graze.lesson') !== null,
      goOn: () => dispatch({ type: 'settings', values: { id: 'own' } }),
      collect: () => collect(encode({ ...state, page: 'explore' })),
      openFile: () => void openFile(),
    });
    render(own, list);
  };

  /** The earlier state object if it is equal, so that models that follow from it stay cached. */
  const asBefore = (state: AppState): AppState => {
    const link = `${encode(state)} ${state.revealed}`;
    if (last?.link !== link) last = { link, state };
    return last.state;
  };

  /** Announces a new step, or a change within a step. */
  const tell = (before: DrawnStep | null, now: DrawnStep): void => {
    const { lesson, number, step } = now.place;
    if (before?.place.lesson !== lesson || before.place.number !== number) {
      heard = null;
      const heading = `${lesson.title}, step ${number} of ${lesson.steps.length}: ${step.title}.`;
      announce(() => `${heading} ${wordsAt('.lesson-text > *')}`, 'step');
    } else if (before.asked && !now.asked) announce(() => wordsAt('.lesson-answer'), 'step');
    if (!now.model || travel.underWay) return;
    heard ??= now.model;
    const old = heard;
    if (old === now.model) return;
    announce(() => {
      const last = shown?.model ?? null;
      const words = last && shown?.place.number === number ? announcement(old, last) : '';
      heard = last;
      return words;
    });
  };
  const wordsAt = (selector: string): string => {
    const found = text.querySelector(selector);
    return found ? wordsOf(found) : '';
  };

  const showStep = (settings: Settings, place: LessonStep): void => {
    const before = shown;
    const { lesson, number, step } = place;
    const target = asBefore(innerState(step, settings));
    const isNew = before?.place.lesson.id !== lesson.id || before.place.number !== number;
    if (isNew) {
      travel.start(before?.inner ?? null, target);
      handIn.clear();
      text.scrollTop = 0;
      if (before) window.scrollTo({ top: 0 });
    }
    const inner = travel.at(target);
    const onExplore = inner.page === 'explore';
    const model = onExplore ? derive(inner) : null;
    const asked = isAsked(step, settings);
    shown = { place, inner, model, asked };
    host.dataset.look = onExplore ? 'explore' : 'other';
    host.dataset.page = inner.page;
    render(nothing, list);
    const sliders = slidersOf(step, target, settings, asked, handIn);
    if (model) {
      others.leave();
      explore ??= mountExplorePart(stage, handIn.inner);
      const letters = lettersIn([...step.text, ...step.question, ...step.answer]);
      explore.render({ model, movable: sliders.movable, normals: letters.has('N') });
    } else others.render(inner, partShown(step.part, inner));
    const { guess } = step;
    // While a question is open, another page is covered, since it would give the answer away.
    const covered = asked && !onExplore && guess && 'quantity' in guess ? guess.quantity : null;
    host.toggleAttribute('data-covered', covered !== null);
    const beside = { model, page: other, asked: covered };
    const prose = proseTools(place, beside, sliders.view);
    const seen = { model, value: (name: string) => prose.value(name)?.value ?? null };
    const answered = guess ? answerView(step, guess, settings.guess, seen, prose) : nothing;
    const parts: StepParts = {
      ...{ lesson, number, step, prose },
      asked: guess && asked ? questionView(step, guess, prose, handIn.tools(step)) : answered,
      slider: sliders.view(),
      isHidden: guess === null && areHidden(step, settings),
      editor: editing.view(place),
    };
    const print = () => void printPage();
    const tools = {
      ...{ go, reveal: handIn.reveal, edit: () => editing.begin(place), save, print },
      ...{ present, problem },
    };
    render(stepView(parts, { ...tools, add: () => collect(encode(target)) }), text);
    if (!onExplore && covered === null) paper.drawn(step);
    if (!forPaper) tell(before, shown);
  };

  /** The live numbers of all of a step's text, as another page has them. */
  const numbersOf = ({ text, question, answer, notes }: Step): Projected['numbers'] => {
    const names = quantitiesIn([...text, ...question, ...answer, ...notes]);
    const found = names.map((name) => [name, valueOnPage(other, name)] as const);
    return Object.fromEntries(found.flatMap(([name, value]) => (value ? [[name, value]] : [])));
  };

  const turn = (by: 1 | -1): void => {
    if (!shown) {
      announce('No lesson is open: choose one.', 'deed');
      return;
    }
    const { lesson, number } = shown.place;
    const end = by === 1 ? lesson.steps.length : 1;
    if (number === end) announce(`This is the ${by === 1 ? 'last' : 'first'} step.`, 'deed');
    editing.cancel();
    handIn.turn(by);
  };

  // A clicker's two keys mean next and back wherever the focus is.
  host.addEventListener(
    'keydown',
    (event) => {
      const by = event.key === 'PageDown' ? 1 : event.key === 'PageUp' ? -1 : null;
      if (by === null || (event.target as Element).closest('textarea')) return;
      event.preventDefault();
      event.stopPropagation();
      turn(by);
    },
    true,
  );

  // Other pages show new results without a new state: numbers in the text follow these.
  new MutationObserver((records) => {
    // Setting an attribute to its present value is ignored: it would cause an endless loop.
    const isNews = records.some(
      ({ type, target, attributeName, oldValue }) =>
        type === 'childList' || (target as Element).getAttribute(attributeName ?? '') !== oldValue,
    );
    if (isNews && shown && !shown.model) changed();
  }).observe(other, {
    subtree: true,
    childList: true,
    attributeOldValue: true,
    attributeFilter: ['data-value', 'data-trace'],
  });

  return {
    render(state) {
      outer = state;
      const settings = forPaper ?? state.settings.lesson;
      const place = lessonStepOf(settings);
      if (place) showStep(settings, place);
      else showList(state);
      if (forPaper) return;
      const numbers = place && shown && !shown.model ? numbersOf(place.step) : {};
      projected.show(() => place && { hash: encode(state), numbers, look: null });
    },
    read: readSettings,
    open: openText,
    turn,
    exports() {
      if (!shown) return [];
      const { lesson } = shown.place;
      const item = { id: 'lesson', title: 'the lesson as a text', file: `${lesson.id}.md` };
      const text = () => writeLesson(lesson);
      return [{ ...item, type: 'text/markdown', text, blob: null }, ...others.exports()];
    },
    present,
    rest() {
      projected.show(() => null);
      others.leave();
    },
  };
};
