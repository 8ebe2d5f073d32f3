import { describe, expect, test } from 'vitest';
import { type Posed, pose } from '../../../../src/check/compose.ts';
import { drawnInput } from '../../../../src/check/drawn-input.ts';
import { EXERCISES } from '../../../../src/check/exercises/index.ts';
import { withParam } from '../../../../src/check/exercises/params.ts';
import type { Answers } from '../../../../src/check/types.ts';
import { definitionOf } from '../../../../src/math/shapes.ts';
import { createQuestionScene } from '../../../../src/pages/check/question-scene.ts';
import { endPoints } from '../../../../src/state/cut-drawing.ts';
import type { SceneModel } from '../../../../src/state/scene-model.ts';
import { stageAround } from '../../../../src/state/stage.ts';
import { INITIAL } from '../../../../src/state/state.ts';
import { display, displayTriple } from '../../../../src/text/format.ts';

const SEEDS = 18;
const ALL: readonly Posed[] = EXERCISES.flatMap((exercise) =>
  Array.from({ length: SEEDS }, (_, i) => {
    const kind = exercise.kinds[i % exercise.kinds.length] as (typeof exercise.kinds)[number];
    return pose(exercise, kind, 31 * (i + 1), ([1, 2, 3] as const)[i % 3] ?? 1);
  }),
);

/**
 * Beside the others stands something else, or E may be so far off that the picture lets go of it.
 */
const ON_PAPER = ALL.filter(({ exercise }) => exercise.paper && !exercise.picture);

/** As the page draws a question that is open. */
function drawn(posed: Posed, answers: Answers | null): SceneModel {
  const shown = drawnInput(posed, answers ?? {});
  const { given } = posed;
  return createQuestionScene()({ ...shown, results: false, answers, given, view: INITIAL.view });
}

const numbersIn = (words: string): string[] => words.match(/[−\d.·⁻⁰¹²³⁴-⁹]+/g) ?? [];

describe('the picture of an open question', () => {
  test('has no hit, no normal, no tick, no bead, and its words no number that is not given', () => {
    for (const posed of ALL) {
      const { hits, bead, ghost, notes, description, ray } = drawn(posed, null);
      expect({ hits, bead, ghost, ticks: ray.ticks }).toEqual({
        hits: [],
        bead: null,
        ghost: null,
        ticks: [],
      });
      const { origin, direction } = posed.draft.ray;
      const note = drawnInput(posed, {}).note;
      const ends = (posed.draft.between ?? []).map((y) => display(y));
      const triples = [displayTriple(origin), displayTriple(origin, 3), displayTriple(direction)];
      const told = numbersIn([...triples, ...ends, note].join(' '));
      for (const x of numbersIn([description, ...notes].join(' ')))
        expect([...told, '.'], description).toContain(x);
      expect([description, ...notes].join(' ')).not.toMatch(
        /[tPN][₁₂]|tangent|touches|inside|outside by|misses|enters|first hit/,
      );
    }
  });

  test('has the size that ray and shapes ask for, and the ray goes all through it', () => {
    for (const posed of ON_PAPER) {
      const { shape, ray, between, other } = drawnInput(posed, {}).input;
      const { stage, ray: shown } = drawn(posed, null);
      const ends = between ? endPoints(shape, between) : [];
      const second = other ? [definitionOf(other).anchor(other).at] : [];
      expect(stage).toEqual(stageAround(shape, [ray.origin, ...ends, ...second]));
      for (const { from, to, stretch } of shown.segments) {
        expect(stretch).toBe(to <= 0 ? 'behind' : 'before');
        expect(from === 0 || to === 0).toBe(true);
        const end = from === 0 ? to : from;
        const off = [0, 1, 2].map(
          (i) => (ray.origin[i] ?? 0) + end * (ray.direction[i] ?? 0) - (stage.center[i] ?? 0),
        );
        expect(Math.hypot(...off) / stage.radius).toBeCloseTo(1.5, 9);
      }
    }
  });

  test('of a parameter asked for is the same for every value, and takes the student’s', () => {
    const asking = ALL.filter(({ exercise }) => exercise.asksForParam);
    expect(asking.length).toBeGreaterThan(0);
    for (const posed of asking) {
      const { param, shape } = posed.draft;
      if (!param) throw new RangeError('no parameter');
      const value = param.value + 1.25;
      const other = {
        ...posed,
        draft: {
          ...posed.draft,
          shape: withParam(shape, param, value),
          param: { ...param, value },
        },
      };
      for (const answers of [null, { value: 3.5 }, { value: -1 }]) {
        expect(JSON.stringify(drawn(other, answers))).toBe(JSON.stringify(drawn(posed, answers)));
      }
      expect(drawn(posed, { value: 3.5 }).description).toContain(`your ${param.symbol} = 3.5`);
    }
  });

  test('shows the student’s own points, and says where they are', () => {
    for (const posed of ON_PAPER) {
      const { origin, direction } = posed.draft.ray;
      const own = origin.map((x, i) => x + 0.5 * (direction[i] ?? 0)) as unknown as typeof origin;
      const { ghost, description, hits } = drawn(posed, { t1: 0.5 });
      expect(ghost?.title).toBe('yours');
      expect(ghost?.hits).toEqual([own]);
      expect(description).toContain(`Yours: ${displayTriple(own, 4)}.`);
      expect(hits).toEqual([]);
    }
  });
});
