import { EFFECTS, type EffectId } from '../scene/effects/index.ts';
import type { PlannedEffect } from '../scene/effects/plan.ts';
import type { Cost, Ledger, RayKind } from './types.ts';

/** What is counted while rays are fired. */
export interface Tally {
  rays: number;
  questions: number;
  roots: number;
  ms: number;
}

export const newTally = (): Tally => ({ rays: 0, questions: 0, roots: 0, ms: 0 });

const NO_KINDS: Readonly<Record<RayKind, number>> = {
  camera: 0,
  shadow: 0,
  reflected: 0,
  refracted: 0,
};

export const EMPTY_LEDGER: Ledger = {
  camera: newTally(),
  effects: {},
  kinds: NO_KINDS,
  saved: 0,
  cut: 0,
};

const addCosts = (a: Cost, b: Cost): Cost => ({
  rays: a.rays + b.rays,
  questions: a.questions + b.questions,
  roots: a.roots + b.roots,
  ms: a.ms + b.ms,
});

/** Two tiles' ledgers as one. */
export function addLedgers(a: Ledger, b: Ledger): Ledger {
  const effects: Partial<Record<EffectId, Cost>> = { ...a.effects };
  for (const { id } of EFFECTS) {
    const more = b.effects[id];
    if (more) effects[id] = addCosts(effects[id] ?? newTally(), more);
  }
  return {
    camera: addCosts(a.camera, b.camera),
    effects,
    kinds: {
      camera: a.kinds.camera + b.kinds.camera,
      shadow: a.kinds.shadow + b.kinds.shadow,
      reflected: a.kinds.reflected + b.kinds.reflected,
      refracted: a.kinds.refracted + b.kinds.refracted,
    },
    saved: a.saved + b.saved,
    cut: a.cut + b.cut,
  };
}

/** All of a picture's costs together. */
export function totalOf(ledger: Ledger): Cost {
  return EFFECTS.reduce(
    (sum, { id }) => addCosts(sum, ledger.effects[id] ?? newTally()),
    ledger.camera,
  );
}

const quoted = (text: string): string => `"${text.replaceAll('"', '""')}"`;

/** The ledger as a table: a line per effect, run or not, and what was counted apart. Times are processor milliseconds, of all workers together. */
export function ledgerCsv(ledger: Ledger, plan: readonly PlannedEffect[]): string {
  const total = totalOf(ledger);
  const share = (ms: number): string => (total.ms > 0 ? (ms / total.ms).toFixed(4) : '0');
  const line = (name: string, needed: string, reason: string, cost: Cost | undefined): string =>
    [
      name,
      needed,
      quoted(reason),
      ...(cost
        ? [cost.rays, cost.questions, cost.roots, cost.ms.toFixed(3), share(cost.ms)]
        : ['', '', '', '', '']),
    ].join(',');
  const effects = plan.map(({ id, needed, reason, forced }) => {
    const word = forced === 'no' ? (needed ? 'needed' : 'not needed') : `forced ${forced}`;
    return line(id, word, reason, ledger.effects[id]);
  });
  const count = (name: string, n: number): string => `${name},,,${n},,,,`;
  return `${[
    'effect,state,reason,rays,questions,roots,ms,share',
    line('camera', 'needed', 'every picture has camera rays', ledger.camera),
    ...effects,
    line('total', '', '', total),
    ...Object.entries(ledger.kinds).map(([kind, n]) => count(`${kind} rays`, n)),
    count('rays saved by the weight bound', ledger.saved),
    count('rays cut by the bounce limit', ledger.cut),
  ].join('\n')}\n`;
}
