import type { Answers, Input } from '../../check/types.ts';
import { evaluateTriple, float64, POINT, valuesOf, withScalars } from '../../math/formula.ts';
import { intersect, type Shape, type Vec3 } from '../../math/index.ts';
import type { View } from '../../state/camera-view.ts';
import { endPoints } from '../../state/cut-drawing.ts';
import { createDerive } from '../../state/derive.ts';
import { exploreDetails } from '../../state/explore-details.ts';
import type { GhostModel, HitMark, SceneModel } from '../../state/scene-model.ts';
import { sceneWithoutResults } from '../../state/scene-without-results.ts';
import { isDrawn } from '../../state/stage.ts';
import { type AppState, INITIAL } from '../../state/state.ts';
import { encode } from '../../state/url.ts';
import { display, displayTriple } from '../../text/format.ts';
import { subscript } from '../../text/scripts.ts';

/** The state of Explore that shows this input. */
function stateOf({ shape, ray, between }: Input): AppState {
  return {
    ...INITIAL,
    kind: shape.kind,
    shapes: { ...INITIAL.shapes, [shape.kind]: shape },
    E: ray.origin,
    d: ray.direction,
    between: between ?? null,
  };
}

/** The link to Explore with this input; null if the input is invalid. */
export function exploreLink(input: Input): string | null {
  const numbers = [
    ...input.ray.origin,
    ...input.ray.direction,
    ...Object.values(input.shape).flat(),
  ];
  const finite = numbers.every((x) => typeof x !== 'number' || Number.isFinite(x));
  return finite ? encode(stateOf(input)) : null;
}

export interface QuestionSceneInput {
  /** The input to draw, without a parameter that is asked for and not yet solved. */
  readonly input: Input;
  /** Whether hits, normals and bead are drawn: once a question is solved or given up. */
  readonly results: boolean;
  /** A student's own values, drawn as a ghost. */
  readonly answers: Answers | null;
  /** Quantities that the question gives. */
  readonly given: Answers;
  /** Words beside the picture and in its description on a hidden quantity; '' for none. */
  readonly note: string;
  readonly view: View;
}

/** Makes the scene of one picture, with a cache of its own. */
export function createQuestionScene(): (wanted: QuestionSceneInput) => SceneModel {
  const derive = createDerive(() => exploreDetails);
  const framed = ({ shape, between }: Input) => (between ? endPoints(shape, between) : []);
  let last: QuestionSceneInput | null = null;
  let before: SceneModel | null = null;
  let state = INITIAL;
  return (wanted) => {
    const { input, results, answers, view } = wanted;
    if (input !== last?.input) state = stateOf(input);
    const same =
      input === last?.input &&
      answers === last.answers &&
      wanted.note === last.note &&
      results === last.results;
    if (!same) before = null;
    last = wanted;
    if (!results) {
      before ??= { ...unsolved(wanted), framed: framed(input) };
      return { ...before, view };
    }
    if (input.other) {
      before ??= solvedOfTwo(wanted, input.other);
      return { ...before, view };
    }
    const { scene } = derive({ ...state, view, revealed: null });
    return { ...scene, handles: [], framed: framed(input), ghost: ghostOf(wanted, scene) };
  };
}

/** The scene of an unsolved question: the input and the student's values, without results. */
function unsolved(wanted: QuestionSceneInput): SceneModel {
  const { input, answers, note, view } = wanted;
  const points = answers ? pointsOf(input, answers).filter(isFinitePoint) : [];
  const scene = sceneWithoutResults(input, points, view);
  const own = points.map((p) => displayTriple(p, 4));
  const words = [
    scene.description,
    ...(own.length > 0 ? [`Yours: ${own.join(' and ')}.`] : []),
    ...(note ? [`${note}.`] : []),
    'The result is not shown before the question is solved.',
  ];
  return {
    ...scene,
    notes: note ? [...scene.notes, note] : scene.notes,
    description: words.join(' '),
    ghost: ghostOf(wanted, scene),
  };
}

/** The scene of two surfaces with the hits of both: t₁, t₂ of the first, s₁, s₂ of the second. */
function solvedOfTwo({ input, view }: QuestionSceneInput, other: Shape): SceneModel {
  const { ray } = input;
  const rootsOf = (shape: Shape) =>
    intersect(shape, ray).hits.map(({ t, point }, i) => ({ t, point, index: i + 1 }));
  const met = [
    ...rootsOf(input.shape),
    ...rootsOf(other).map((root) => ({ ...root, letter: 's' as const })),
  ];
  const first = Math.min(...met.filter(({ t }) => t >= 0).map(({ t }) => t));
  const scene = sceneWithoutResults(
    input,
    met.map(({ point }) => point),
    view,
  );
  const hits = met.map(
    (root): HitMark => ({
      ...{ ...root, normal: null, drawn: isDrawn(root.point, scene.stage) },
      role: root.t < 0 ? 'behind' : Object.is(root.t, first) ? 'first' : 'other',
    }),
  );
  const said = [...hits]
    .sort((a, b) => a.t - b.t)
    .map(({ letter = 't', index, t }) => `${letter}${subscript(index)} = ${display(t, 4)}`);
  return { ...scene, hits, description: `${scene.description} Hits: ${said.join(', ')}.` };
}

const isFinitePoint = (p: Vec3): boolean => p.every(Number.isFinite);

/** A ghost with the student's t's, points or normal; null if none of them can be drawn. */
function ghostOf(
  { input, answers, given }: QuestionSceneInput,
  scene: SceneModel,
): GhostModel | null {
  if (!answers) return null;
  const { stage, ray, hits } = scene;
  const normal = ['N', 'N1'].map((id) => answers[id]).find((v) => typeof v === 'object');
  const at = given.P ?? answers.P1 ?? hits.find(({ role }) => role === 'first')?.point;
  if (normal && typeof at === 'object') return arrow(at, normal, stage.radius);
  const points = pointsOf(input, answers).filter(isFinitePoint);
  const [first] = ray.segments;
  const last = ray.segments.at(-1);
  if (points.length === 0 || !first || !last) return null;
  return {
    title: 'yours',
    origin: ray.origin,
    direction: ray.direction,
    from: first.from,
    to: last.to,
    hits: points.filter((p) => isDrawn(p, stage)),
    beside: points.find((p) => isDrawn(p, stage)) ?? null,
  };
}

function arrow(from: Vec3, [x, y, z]: Vec3, radius: number): GhostModel | null {
  const length = Math.hypot(x, y, z);
  if (!(length > 0) || !Number.isFinite(length)) return null;
  const k = (0.3 * radius) / length;
  const to: Vec3 = [from[0] + k * x, from[1] + k * y, from[2] + k * z];
  return {
    title: 'yours',
    origin: from,
    direction: [k * x, k * y, k * z],
    from: 0,
    to: 1,
    hits: [to],
    beside: to,
  };
}

function pointsOf(input: Input, answers: Answers): Vec3[] {
  const values = valuesOf(input.shape, input.ray, float64);
  const at = (t: number): Vec3 => evaluateTriple(POINT, float64, withScalars(values, { t }));
  const ts = ['t', 't1', 't2', 's1', 's2'].flatMap((id) => {
    const t = answers[id];
    return typeof t === 'number' ? [at(t)] : [];
  });
  const points = ['P', 'P1', 'P2'].flatMap((id) => {
    const p = answers[id];
    return typeof p === 'object' ? [p] : [];
  });
  return [...ts, ...points];
}
