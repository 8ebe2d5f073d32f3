import type {
  BounceBody,
  EffectBody,
  Feelers,
  GlossBody,
  LightBody,
  Lit,
  PaintBody,
  RootsBody,
  Tools,
  Wave,
  WayBody,
  WorldLight,
} from '../scene/effects/body.ts';
import type { EffectId } from '../scene/effects/index.ts';
import type { Scene } from '../scene/types.ts';
import { createFinder } from './find.ts';
import { newTally, type Tally } from './ledger.ts';
import { type Film, face, gather, light, meet, paint } from './shade.ts';
import type { Cost, Ledger, RayKind, TraceSettings } from './types.ts';
import { capacityOf, clear, createFeelers, createLit, createWave, withRoom } from './wave.ts';
import { brightest, HALF_A_LEVEL, MOST_BOUNCES } from './weight.ts';
import { worldOf } from './world.ts';

/** An effect that takes part: its code, and whether it was forced on where nothing calls for it. */
export interface Part<B extends EffectBody = EffectBody> {
  readonly id: EffectId;
  readonly body: B;
  readonly all: boolean;
}

/** Sees every ray; for ray trees. */
export interface Recorder {
  /** Hits are known. Puts a number of its own for each ray into wave.node, which holds that of the ray before. */
  wave(wave: Wave): void;
  feelers(feelers: Feelers, light: WorldLight): void;
}

export interface Engine {
  /** The wave to put camera rays into, with room for so many. */
  camera(count: number): Wave;
  /** Follows them until nothing more can change, and adds what they bring to the film, which begins at 0. */
  follow(camera: Wave, film: Film, recorder?: Recorder): Ledger;
}

type At<K extends EffectBody['at']> = Extract<EffectBody, { readonly at: K }>;

/** The tracer of a scene, put together from the effects that take part: for the others there is no branch in it. */
export function createEngine(
  scene: Scene,
  settings: TraceSettings,
  parts: readonly Part[],
  clock: () => number,
): Engine {
  const those = <K extends EffectBody['at']>(at: K): Part<At<K>>[] =>
    parts.filter((part): part is Part<At<K>> => part.body.at === at);
  const tallies = new Map<EffectId, Tally>(parts.map(({ id }) => [id, newTally()]));
  const tallyOf = (id: EffectId): Tally => tallies.get(id) as Tally;
  const [heights] = those<'roots'>('roots') as Part<RootsBody>[];
  const ways = those('way') as Part<WayBody>[];
  const paints = those('paint') as Part<PaintBody>[];
  const lights = those('light') as Part<LightBody>[];
  const glosses = those('gloss') as Part<GlossBody>[];
  const bounces = those('bounce') as Part<BounceBody>[];

  const world = worldOf(scene, settings.method, heights ? (heights.all ? 'all' : 'needed') : 'off');
  const finder = createFinder(
    world.targets,
    settings.start,
    heights && { body: heights.body, tally: tallyOf(heights.id), clock },
  );
  const least = HALF_A_LEVEL / brightest(world, scene.ambient);

  let own = newTally();
  let kinds: Record<RayKind, number> = { camera: 0, shadow: 0, reflected: 0, refracted: 0 };
  let saved = 0;
  let cut = 0;
  let feelers = createFeelers(4096);
  let lits: Lit[] = [];
  let first = createWave(0);
  let generation = 0;
  let watching: Recorder | undefined;

  /** Waves of one cause: one is read while the next generation is put into the other. */
  interface Cause {
    readonly part: Part<BounceBody>;
    readonly tools: Tools;
    now: Wave;
    next: Wave;
  }
  const causes = bounces.map((part): Cause => {
    const cause: Cause = {
      part,
      now: createWave(256),
      next: createWave(256),
      tools: toolsOf(part, (count) => {
        cause.next = withRoom(cause.next, count);
        return cause.next;
      }),
    };
    return cause;
  });
  const lighting = lights.map((part) => ({ part, tools: toolsOf(part, () => first) }));

  function toolsOf({ id }: Part, next: (count: number) => Wave): Tools {
    return {
      lightSamples: settings.lightSamples,
      next,
      feelers(count) {
        if (feelers.limit.length < count) feelers = createFeelers(2 * count);
        feelers.count = 0;
        return feelers;
      },
      feel(asked, about) {
        const tally = tallyOf(id);
        asked.rays.count = asked.count;
        tally.rays += asked.count;
        kinds.shadow += asked.count;
        finder.blocked(asked, tally);
        watching?.feelers(asked, about);
      },
      worth(weight) {
        if (generation >= MOST_BOUNCES) {
          cut += 1;
          return false;
        }
        if (weight > least) return true;
        saved += 1;
        return false;
      },
      fired(kind, count) {
        kinds[kind] += count;
        tallyOf(id).rays += count;
      },
    };
  }

  const heightsMs = (): number => (heights ? tallyOf(heights.id).ms : 0);

  /** Runs a step and puts its time to its effect, but for what choosing by height took within. Returns all of it. */
  function timed({ id }: Part, run: () => void): number {
    const tally = tallyOf(id);
    const chosen = heightsMs();
    const before = clock();
    run();
    const spent = clock() - before;
    tally.ms += spent - (heightsMs() - chosen);
    return spent;
  }

  function illuminate(wave: Wave): number {
    let others = 0;
    if (lits.length === 0 || (lits[0] as Lit).reach.length < wave.hitCount) {
      lits = world.lights.map((one) => createLit(one, capacityOf(wave)));
    }
    for (const lit of lits) {
      face(wave, world, lit.light, lit);
      if (lit.count === 0) continue;
      for (const { part, tools } of lighting) {
        others += timed(part, () => part.body.run(wave, lit, tools, part.all));
      }
      light(wave, lit);
      for (const part of glosses) {
        others += timed(part, () => part.body.run(wave, lit, world, part.all));
      }
    }
    return others;
  }

  /** One wave from its rays to what they bring and the rays that follow. `cause` gets the time that no effect claims. */
  function pass(wave: Wave, cause: Tally, film: Film): void {
    const before = clock();
    const chosen = heightsMs();
    finder.nearest(wave, cause);
    let others = heightsMs() - chosen;
    meet(wave, world);
    watching?.wave(wave);
    for (const part of ways) others += timed(part, () => part.body.run(wave, world, part.all));
    paint(wave, world, scene.ambient);
    for (const part of paints) others += timed(part, () => part.body.run(wave, world, part.all));
    others += illuminate(wave);
    gather(wave, world, scene.background, film);
    for (const { part, tools } of causes) {
      others += timed(part, () => part.body.run(wave, world, tools, part.all));
    }
    cause.ms += clock() - before - others;
  }

  function reset(): void {
    own = newTally();
    for (const tally of tallies.values()) Object.assign(tally, newTally());
    kinds = { camera: 0, shadow: 0, reflected: 0, refracted: 0 };
    saved = 0;
    cut = 0;
  }

  function turn(): boolean {
    let any = false;
    for (const cause of causes) {
      const { now, next } = cause;
      cause.now = next;
      cause.next = now;
      clear(cause.next, generation + 1);
      cause.now.depth = generation;
      if (cause.now.count > 0) any = true;
    }
    return any;
  }

  return {
    camera(count) {
      if (capacityOf(first) < count) first = createWave(count);
      clear(first, 0);
      return first;
    },
    follow(camera, film, recorder) {
      watching = recorder;
      generation = 0;
      reset();
      for (const cause of causes) clear(cause.next, 1);
      kinds.camera = camera.count;
      own.rays = camera.count;
      pass(camera, own, film);
      generation = 1;
      while (turn()) {
        for (const cause of causes) {
          if (cause.now.count > 0) pass(cause.now, tallyOf(cause.part.id), film);
        }
        generation += 1;
      }
      const effects: Partial<Record<EffectId, Cost>> = {};
      for (const [id, tally] of tallies) effects[id] = { ...tally };
      return { camera: { ...own }, effects, kinds: { ...kinds }, saved, cut };
    },
  };
}
