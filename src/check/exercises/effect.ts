import type { Shape } from '../../math/index.ts';
import { pick, type Random } from '../../math/rng.ts';
import { definitionOf, type ShapeKind } from '../../math/shapes.ts';
import { EFFECTS } from '../../scene/effects/index.ts';
import { findPreset } from '../../scene/presets/index.ts';
import type { Light, Scene, Thing } from '../../scene/types.ts';
import { choiceField } from '../types.ts';
import { type Exercise, spreadOver, type Told } from './define.ts';
import { shuffled } from './draw.ts';

/*
 * Scenes, their things and what they need are those of the registries. Which of them are asked
 * about is fixed, so that a seed poses the same when there are more.
 */

const SCENES: readonly string[] = [
  ...['plain', 'shadows', 'mirror', 'cone-on-mirror', 'facing-mirrors', 'glass', 'coloured-glass'],
  ...['soft-light', 'six-shapes', 'far', 'grazing', 'two-scales'],
];
const ASKED: readonly string[] = [
  ...['shadow', 'soft-shadow', 'reflection', 'refraction', 'absorption', 'pattern'],
  ...['highlights', 'heights'],
];

/** Number of effects, and of reasons, to choose from. */
const OFFERED = 4;

const effectOf = (id: string) => EFFECTS.find((one) => one.id === id);
const titleOf = (id: string): string => effectOf(id)?.title ?? id;
const needOf = (id: string, scene: Scene) => effectOf(id)?.neededBy(scene);

const sceneOf = (id: string): Scene | undefined => findPreset(id)?.scene;
const scenes = SCENES.flatMap((id) => {
  const scene = sceneOf(id);
  return scene ? [{ id, scene }] : [];
});

/** Effects that nature would not show there either, with the reason. */
const needless = (scene: Scene) =>
  ASKED.flatMap((id) => {
    const need = needOf(id, scene);
    return need && !need.needed && !need.leftOut ? [{ id, reason: need.reason }] : [];
  });

const needed = (scene: Scene): string[] => ASKED.filter((id) => needOf(id, scene)?.needed);

const names = ({ things, lights }: Scene): string[] => [...things, ...lights].map(({ id }) => id);

/** Every reason that is given in some scene and names none of its things. */
const REASONS: readonly string[] = [
  ...new Set(
    scenes.flatMap(({ scene }) =>
      needless(scene)
        .map(({ reason }) => reason)
        .filter((reason) => !names(scene).some((name) => reason.includes(name))),
    ),
  ),
];

/** Scenes with a shape, and the effects that may be asked about there. */
const about = (kind: ShapeKind) =>
  scenes
    .filter(({ scene }) => scene.things.some(({ shape }) => Object.is(shape.kind, kind)))
    .map(({ id, scene }) => ({
      ...{ id, scene, needed: needed(scene) },
      needless: needless(scene).filter(({ reason }) => REASONS.includes(reason)),
    }))
    .filter((one) => one.needless.length > 0 && one.needed.length >= 2);

const KINDS: readonly ShapeKind[] = (
  ['plane', 'cylinder', 'cone', 'hyperboloid', 'circle', 'square', 'sphere', 'paraboloid'] as const
).filter((kind) => about(kind).length > 0);

/** Effects that no scene with this shape is without. */
const without = Object.fromEntries(
  KINDS.map((kind) => {
    const some = new Set(about(kind).flatMap((one) => one.needless.map(({ id }) => id)));
    return [kind, ASKED.filter((id) => !some.has(id))];
  }),
);

const materialWords = ({ material, between }: Thing): string => {
  const { paint, shine, mirror, glass } = material;
  const coloured = glass?.absorption.some((x) => x > 0) ?? false;
  const words = [
    mirror > 0 ? 'a mirror' : '',
    glass ? `${coloured ? 'coloured' : 'clear'} glass` : '',
    paint.pattern === 'plain' ? '' : paint.pattern,
    shine.strength > 0 ? 'shiny' : '',
    between ? 'between two heights' : '',
  ].filter((word) => word !== '');
  return words.length > 0 ? words.join(', ') : 'plain and dull';
};

const LIGHTS: Readonly<Record<Light['light'], string>> = {
  point: 'a light without size',
  sun: 'the sun',
  sphere: 'a light with a size',
};

/** "2 × ": things that read the same are said once. */
function grouped(lines: readonly string[]): string {
  const counts = new Map<string, number>();
  for (const line of lines) counts.set(line, (counts.get(line) ?? 0) + 1);
  return [...counts].map(([line, n]) => (n === 1 ? line : `${n} × ${line}`)).join('; ');
}

function told(scene: Scene): Told[] {
  const things = scene.things.map(
    (thing) => `${definitionOf(thing.shape).title}: ${materialWords(thing)}`,
  );
  const lights = scene.lights.map(({ light }) => LIGHTS[light]);
  return [
    { name: 'things', says: grouped(things) },
    { name: 'lights', says: lights.length > 0 ? grouped(lights) : 'none' },
  ];
}

const some = <T>(random: Random, list: readonly T[], count: number): T[] =>
  shuffled(random, list).slice(0, count);

const options = (ids: readonly string[], title: (id: string) => string) =>
  ids.map((id) => ({ id, title: title(id) }));

/** An id for a reason, of its letters. */
export const slug = (reason: string): string => reason.toLowerCase().replace(/[^a-z]+/g, '-');

export const effect: Exercise = {
  id: 'effect',
  topic: 'an effect that a scene does not need',
  subject: 'scene',
  picture: 'none',
  hidden: 'all',
  paper: true,
  kinds: KINDS,
  spread: spreadOver('effect', ASKED, without),
  draw(random, kind, _, wanted) {
    const isAsked = ({ id }: { id: string }): boolean => wanted === undefined || id === wanted;
    const [first, ...others] = about(kind).filter((one) => one.needless.some(isAsked));
    if (!first) return null;
    const { id, scene, needed: all, needless: none } = pick(random, [first, ...others]);
    const [one, ...more] = none.filter(isAsked);
    const thing = scene.things.find(({ shape }) => Object.is(shape.kind, kind));
    if (!one || !thing) return null;
    const right = pick(random, [one, ...more]);
    const said = new Set(none.map(({ reason }) => reason));
    const wrong = REASONS.filter((reason) => !said.has(reason));
    if (wrong.length < OFFERED - 1) return null;
    const { eye, target } = scene.camera;
    return {
      shape: thing.shape as Shape,
      ray: {
        origin: eye,
        direction: [target[0] - eye[0], target[1] - eye[1], target[2] - eye[2]],
      },
      scene: {
        id,
        effects: shuffled(random, [right.id, ...some(random, all, OFFERED - 1)]),
        reasons: shuffled(random, [right.reason, ...some(random, wrong, OFFERED - 1)]),
      },
      watch: [],
    };
  },
  ask: () => 'Which of these effects does this scene not need, and why?',
  given: [],
  told: ({ scene }) => told(sceneOf(scene?.id ?? '') ?? { ...NOTHING }),
  fields: ({ scene }) => [
    choiceField('effect', 'it does not need', options(scene?.effects ?? [], titleOf)),
    choiceField(
      'reason',
      'because',
      (scene?.reasons ?? []).map((reason) => ({ id: slug(reason), title: reason })),
    ),
  ],
  answers(_, { scene }) {
    const found = sceneOf(scene?.id ?? '');
    const id = found && scene?.effects.find((one) => needOf(one, found)?.needed === false);
    const reason = found && id ? needOf(id, found)?.reason : undefined;
    return id && reason ? { effect: id, reason: slug(reason) } : {};
  },
  argue({ scene }) {
    const found = sceneOf(scene?.id ?? '');
    if (!found || !scene) return { rule: '', put: '', decision: [] };
    const each = scene.effects.map((id) => {
      const need = needOf(id, found);
      return `${titleOf(id)}: ${need?.needed ? 'needed' : 'not needed'}, ${need?.reason}.`;
    });
    const ideas = scene.effects.map((id) => `${titleOf(id)}: ${effectOf(id)?.idea}`);
    return {
      rule: ideas.join(' '),
      put: `What of the scene calls for ${scene.effects.map(titleOf).join(', for ')}?`,
      decision: each,
    };
  },
  clue: 'An effect is needed if something in the scene would look different without it.',
  lines: [],
};

const NOTHING: Scene = {
  title: '',
  camera: { eye: [0, 0, 1], target: [0, 0, 0], angle: 40 },
  background: { low: '#000000', high: '#000000' },
  ambient: 0,
  things: [],
  lights: [],
};
