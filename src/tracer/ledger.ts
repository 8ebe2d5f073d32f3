import { EFFECTS, type EffectId } from '../scene/effects/index.ts';
import type { Cost, Ledger, RayKind, Work } from './types.ts';

/** Counts of one cause while rays are traced. */
export interface Tally {
  rays: number;
  questions: number;
  solves: number;
  roots: number;
  ms: number;
}

export const newTally = (): Tally => ({ rays: 0, questions: 0, solves: 0, roots: 0, ms: 0 });

/** Counts of each kind of ray. */
export const newKinds = (): Record<RayKind, { -readonly [K in keyof Work]: number }> => ({
  camera: { rays: 0, questions: 0, roots: 0 },
  shadow: { rays: 0, questions: 0, roots: 0 },
  reflected: { rays: 0, questions: 0, roots: 0 },
  refracted: { rays: 0, questions: 0, roots: 0 },
});

export const EMPTY_LEDGER: Ledger = {
  camera: newTally(),
  effects: {},
  kinds: newKinds(),
  fired: {},
  saved: 0,
  cut: 0,
};

const addCosts = (a: Cost, b: Cost): Cost => ({
  rays: a.rays + b.rays,
  questions: a.questions + b.questions,
  solves: a.solves + b.solves,
  roots: a.roots + b.roots,
  ms: a.ms + b.ms,
});

const addWork = (a: Work, b: Work): Work => ({
  rays: a.rays + b.rays,
  questions: a.questions + b.questions,
  roots: a.roots + b.roots,
});

type Fired = NonNullable<Ledger['fired'][EffectId]>;

function addFired(a: Fired, b: Fired): Fired {
  const sum: Partial<Record<RayKind, number>> = { ...a };
  for (const [kind, rays] of Object.entries(b) as [RayKind, number][]) {
    sum[kind] = (sum[kind] ?? 0) + rays;
  }
  return sum;
}

/** The sum of two tiles' ledgers. */
export function addLedgers(a: Ledger, b: Ledger): Ledger {
  const effects: Partial<Record<EffectId, Cost>> = { ...a.effects };
  const fired: Partial<Record<EffectId, Fired>> = { ...a.fired };
  for (const { id } of EFFECTS) {
    const more = b.effects[id];
    if (more) effects[id] = addCosts(effects[id] ?? newTally(), more);
    const also = b.fired[id];
    if (also) fired[id] = addFired(fired[id] ?? {}, also);
  }
  return {
    camera: addCosts(a.camera, b.camera),
    effects,
    kinds: {
      camera: addWork(a.kinds.camera, b.kinds.camera),
      shadow: addWork(a.kinds.shadow, b.kinds.shadow),
      reflected: addWork(a.kinds.reflected, b.kinds.reflected),
      refracted: addWork(a.kinds.refracted, b.kinds.refracted),
    },
    fired,
    saved: a.saved + b.saved,
    cut: a.cut + b.cut,
  };
}

/** The sum of all costs of a picture. */
export function totalOf(ledger: Ledger): Cost {
  return EFFECTS.reduce(
    (sum, { id }) => addCosts(sum, ledger.effects[id] ?? newTally()),
    ledger.camera,
  );
}
