import type {
  EffectBody,
  Lit,
  ShadowRays,
  Tools,
  Wave,
  WorldLight,
} from '../scene/effects/body.ts';
import type { Scene } from '../scene/types.ts';
import { type Counts, createCounts, type Part } from './counts.ts';
import { createFinder } from './find.ts';
import type { Tally } from './ledger.ts';
import { adderOf, type Film, face, gather, light, meet, paint } from './shade.ts';
import { type Ledger, NOTHING, type PixelWork, type RayKind, type TraceSettings } from './types.ts';
import { capacityOf, clear, createLit, createShadowRays, createWave, withRoom } from './wave.ts';
import { brightest, HALF_A_LEVEL, MOST_BOUNCES } from './weight.ts';
import { worldOf } from './world.ts';

/** Is called with every wave; for ray trees. */
export interface Recorder {
  /**
   * Called when the hits are known. Replaces wave.node, the parent's node of each ray, by the ray's
   * own.
   */
  wave(wave: Wave): void;
  shadowRays(shadowRays: ShadowRays, light: WorldLight): void;
}

export interface Engine {
  /** The wave for camera rays, with room for `count`. */
  camera(count: number): Wave;
  /**
   * Traces camera rays and all rays they cause; adds their light to the film and their work to that
   * of their samples, both initially 0.
   */
  follow(camera: Wave, film: Film, work?: PixelWork, recorder?: Recorder): Ledger;
}

/** By CAMERA, REFLECTED, REFRACTED. */
const KINDS: readonly RayKind[] = ['camera', 'reflected', 'refracted'];
const shadowKind = (): RayKind => 'shadow';

type At<K extends EffectBody['at']> = Extract<EffectBody, { readonly at: K }>;

/** An effect that fires rays: one wave is traced while the other collects the next generation. */
interface Cause {
  readonly part: Part<At<'bounce'>>;
  readonly tools: Tools;
  now: Wave;
  next: Wave;
}

/**
 * The tracer of a scene, made of the effects that run; the others cost nothing. A ray is not fired
 * if it can bring no more than `unseen` of linear light.
 */
export function createEngine(
  scene: Scene,
  settings: TraceSettings,
  parts: readonly Part[],
  clock: () => number,
  unseen = HALF_A_LEVEL,
): Engine {
  const those = <K extends EffectBody['at']>(at: K): Part<At<K>>[] =>
    parts.filter((part): part is Part<At<K>> => part.body.at === at);
  const [heights] = those('roots');
  const ways = those('medium');
  const paints = those('paint');
  const lights = those('light');
  const glosses = those('gloss');

  const cutting = heights ? (heights.all ? 'all' : 'needed') : 'off';
  const world = worldOf(scene, settings.method, cutting);
  const wayBodies = ways.map(({ body }) => body);
  const least = unseen / brightest(world, scene.ambient, wayBodies);

  let counts: Counts = createCounts(parts, clock);
  const finder = createFinder(
    world.targets,
    settings.start,
    heights && {
      body: heights.body,
      clock,
      spend: (solves, ms) => {
        const tally = counts.tallyOf(heights.id);
        tally.solves += solves;
        tally.ms += ms;
      },
    },
    settings.boxless ? Number.POSITIVE_INFINITY : undefined,
  );
  const bounces = Math.min(settings.bounces ?? MOST_BOUNCES, MOST_BOUNCES);
  let shadowRays = createShadowRays(4096);
  let lits: Lit[] = [];
  let first = createWave(0);
  let generation = 0;
  let watching: Recorder | undefined;

  const lighting = lights.map((part) => ({ part, tools: toolsOf(part, () => first) }));
  const causes = those('bounce').map((part): Cause => {
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

  function toolsOf({ id }: Part, next: (count: number) => Wave): Tools {
    return {
      lightSamples: settings.lightSamples,
      next,
      shadowRays(count) {
        if (shadowRays.limit.length < count) shadowRays = createShadowRays(2 * count);
        shadowRays.count = 0;
        return shadowRays;
      },
      findBlockers(asked, about) {
        const tally = counts.tallyOf(id);
        asked.rays.count = asked.count;
        counts.fire(id, 'shadow', asked.count);
        finder.blocked(asked, tally);
        counts.spent(asked, shadowKind);
        watching?.shadowRays(asked, about);
      },
      through(asked, about) {
        const tally = counts.tallyOf(id);
        counts.fire(id, 'shadow', asked.count);
        const chords = finder.through(asked, tally);
        counts.spent(asked, shadowKind);
        asked.blocker.fill(NOTHING, 0, asked.count);
        asked.t.set(asked.limit.subarray(0, asked.count));
        watching?.shadowRays(asked, about);
        return chords;
      },
      worth(weight) {
        if (generation >= bounces) counts.cut();
        else if (weight > least) return true;
        else counts.save();
        return false;
      },
      fired(kind, count) {
        counts.fire(id, kind, count);
      },
    };
  }

  function illuminate(wave: Wave): number {
    let others = 0;
    if ((lits[0]?.reach.length ?? 0) < wave.hitCount) {
      lits = world.lights.map((one) => createLit(one, capacityOf(wave)));
    }
    for (const lit of lits) {
      face(wave, world, lit.light, lit);
      if (lit.count === 0) continue;
      for (const { part, tools } of lighting) {
        others += counts.timed(part, () => part.body.run(wave, lit, tools, part.all, world));
      }
      light(wave, lit);
      for (const part of glosses) {
        others += counts.timed(part, () => part.body.run(wave, lit, world, part.all));
      }
    }
    return others;
  }

  /** Processes one wave. Time outside of effects is added to `cause`. */
  function pass(wave: Wave, cause: Tally, film: Film): void {
    const before = clock();
    const chosen = counts.heightsMs();
    finder.nearest(wave, cause);
    counts.spent(wave, (i) => KINDS[wave.kind[i] as number] ?? 'camera');
    let others = counts.heightsMs() - chosen;
    meet(wave, world);
    watching?.wave(wave);
    const add = adderOf(wave, film);
    for (const part of ways) {
      others += counts.timed(part, () => part.body.run(wave, world, part.all, add));
    }
    paint(wave, world, scene.ambient);
    for (const part of paints) {
      others += counts.timed(part, () => part.body.run(wave, world, part.all));
    }
    others += illuminate(wave);
    gather(wave, world, scene.background, film);
    for (const { part, tools } of causes) {
      others += counts.timed(part, () => part.body.run(wave, world, tools, part.all));
    }
    cause.ms += clock() - before - others;
  }

  /** Makes the fired rays those to trace next; false if there are none. */
  function turn(): boolean {
    let any = false;
    for (const cause of causes) {
      const { now, next } = cause;
      cause.now = next;
      cause.next = now;
      clear(now, generation + 1);
      if (next.count > 0) any = true;
    }
    return any;
  }

  return {
    camera(count) {
      if (capacityOf(first) < count) first = createWave(count);
      clear(first, 0);
      return first;
    },
    follow(camera, film, work, recorder) {
      watching = recorder;
      generation = 0;
      counts = createCounts(parts, clock, work);
      for (const cause of causes) clear(cause.next, 1);
      counts.start(camera.count);
      pass(camera, counts.camera, film);
      generation = 1;
      while (turn()) {
        // In the order of effects, so that sums do not depend on how the picture is tiled.
        for (const cause of causes) {
          if (cause.now.count > 0) pass(cause.now, counts.tallyOf(cause.part.id), film);
        }
        generation += 1;
      }
      return counts.ledger();
    },
  };
}
