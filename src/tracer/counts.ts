import type { EffectBody, ShadowRays, Wave } from '../scene/effects/body.ts';
import type { EffectId } from '../scene/effects/index.ts';
import { newKinds, newTally, type Tally } from './ledger.ts';
import type { Cost, Ledger, PixelWork, RayKind } from './types.ts';

/** An effect that runs: its body, and whether it was forced on though not needed. */
export interface Part<B extends EffectBody = EffectBody> {
  readonly id: EffectId;
  readonly body: B;
  readonly all: boolean;
}

type Asked = Pick<Wave | ShadowRays, 'count' | 'sample' | 'asked' | 'found'>;

/** Counters while rays are traced. */
export interface Counts {
  /** Counts of camera rays. */
  readonly camera: Tally;
  tallyOf(id: EffectId): Tally;
  /** Counts rays of a kind that an effect fires. */
  fire(id: EffectId, kind: RayKind, rays: number): void;
  /** Counts camera rays. */
  start(rays: number): void;
  /** Adds up what rays of a wave, or shadow rays, asked and found, by kind and by sample. */
  spent(rays: Asked, kindOf: (i: number) => RayKind): void;
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

export function createCounts(
  parts: readonly Part[],
  clock: () => number,
  work?: PixelWork,
): Counts {
  const camera = newTally();
  const tallies = new Map<EffectId, Tally>(parts.map(({ id }) => [id, newTally()]));
  const kinds = newKinds();
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
      kinds[kind].rays += rays;
      tallyOf(id).rays += rays;
      const own = fired.get(id) ?? {};
      fired.set(id, { ...own, [kind]: (own[kind] ?? 0) + rays });
    },
    start(rays) {
      kinds.camera.rays += rays;
      camera.rays += rays;
    },
    spent({ count, sample, asked, found }, kindOf) {
      for (let i = 0; i < count; i++) {
        const at = sample[i] as number;
        if (work) work.rays[at] = (work.rays[at] as number) + 1;
        const questions = asked[i] as number;
        // Rays that meet no box ask nothing.
        if (questions === 0) continue;
        const roots = found[i] as number;
        const kind = kinds[kindOf(i)];
        kind.questions += questions;
        kind.roots += roots;
        if (!work) continue;
        work.questions[at] = (work.questions[at] as number) + questions;
        work.roots[at] = (work.roots[at] as number) + roots;
      }
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
        kinds,
        fired: Object.fromEntries(fired),
        saved,
        cut,
      };
    },
  };
}
