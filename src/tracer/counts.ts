import type { EffectBody } from '../scene/effects/body.ts';
import type { EffectId } from '../scene/effects/index.ts';
import { newTally, type Tally } from './ledger.ts';
import type { Cost, Ledger, RayKind } from './types.ts';

/** An effect that runs: its body, and whether it was forced on though not needed. */
export interface Part<B extends EffectBody = EffectBody> {
  readonly id: EffectId;
  readonly body: B;
  readonly all: boolean;
}

/** Counters while rays are traced. */
export interface Counts {
  /** Counts of camera rays. */
  readonly camera: Tally;
  tallyOf(id: EffectId): Tally;
  /** Counts rays of a kind that an effect fires. */
  fire(id: EffectId, kind: RayKind, rays: number): void;
  /** Counts camera rays. */
  start(rays: number): void;
  save(): void;
  cut(): void;
  /**
   * Runs a step of an effect and adds its time, without that of heights within, to the effect's
   * count. Returns the whole time in ms.
   */
  timed(part: Part, run: () => void): number;
  /** Time of heights so far, in ms. */
  heightsMs(): number;
  /** All counts as plain data. */
  ledger(): Ledger;
}

export function createCounts(parts: readonly Part[], clock: () => number): Counts {
  const camera = newTally();
  const tallies = new Map<EffectId, Tally>(parts.map(({ id }) => [id, newTally()]));
  const kinds: Record<RayKind, number> = { camera: 0, shadow: 0, reflected: 0, refracted: 0 };
  const fired = new Map<EffectId, Partial<Record<RayKind, number>>>();
  const heights = parts.find(({ body }) => body.at === 'roots');
  let saved = 0;
  let cut = 0;

  const tallyOf = (id: EffectId): Tally => tallies.get(id) ?? camera;
  const heightsMs = (): number => (heights ? tallyOf(heights.id).ms : 0);

  return {
    camera,
    tallyOf,
    heightsMs,
    fire(id, kind, rays) {
      if (rays === 0) return;
      kinds[kind] += rays;
      tallyOf(id).rays += rays;
      const own = fired.get(id) ?? {};
      fired.set(id, { ...own, [kind]: (own[kind] ?? 0) + rays });
    },
    start(rays) {
      kinds.camera += rays;
      camera.rays += rays;
    },
    save() {
      saved += 1;
    },
    cut() {
      cut += 1;
    },
    timed({ id }, run) {
      const tally = tallyOf(id);
      const chosen = heightsMs();
      const before = clock();
      run();
      const spent = clock() - before;
      tally.ms += spent - (heightsMs() - chosen);
      return spent;
    },
    ledger() {
      const effects: Partial<Record<EffectId, Cost>> = {};
      for (const [id, tally] of tallies) effects[id] = { ...tally };
      return {
        camera: { ...camera },
        effects,
        kinds: { ...kinds },
        fired: Object.fromEntries(fired),
        saved,
        cut,
      };
    },
  };
}
