import { EFFECTS, type EffectId } from '../../scene/effects/index.ts';
import { type PlannedEffect, planEffects } from '../../scene/effects/plan.ts';
import type { Scene } from '../../scene/types.ts';
import { type Cell, csv } from '../../text/csv.ts';
import type { Cost, Ledger, RayKind, TraceSettings, Work } from '../../tracer/types.ts';
import { type BuildUp, buildUpOf } from './build-up.ts';
import type { Spread, Times } from './times.ts';

/** Measures of the bars; all but the time are the same on every machine. */
export const MEASURES = ['questions', 'rays', 'solves', 'roots', 'ms'] as const;
export type Measure = (typeof MEASURES)[number];
export const MEASURE_WORDS: Readonly<Record<Measure, string>> = {
  rays: 'rays',
  questions: 'questions',
  solves: 'roots worked out',
  roots: 'roots found',
  ms: 'time',
};

/** One effect in the ledger. */
export interface LedgerRow extends PlannedEffect {
  /** Null while nothing has been traced, and for what does not run. */
  readonly cost: Cost | null;
  /** Its time in repeats of the warm picture; null before they were made, and for what is idle. */
  readonly time: Spread | null;
  /** If it is forced, times of the picture in which it is as called for; null before measuring. */
  readonly unforced: Times | null;
  /** Its share of the measure, 0 … 1, and the sum of the shares in the rows above. */
  readonly share: number;
  readonly from: number;
  /**
   * Pixels that are another colour without it (or, forced off, with it); null if nobody has
   * counted.
   */
  readonly pixels: number | null;
}

export interface LedgerModel {
  readonly camera: Omit<LedgerRow, keyof PlannedEffect | 'unforced'>;
  /** What runs, in the order of the registry, then what does not. */
  readonly simulated: readonly LedgerRow[];
  readonly idle: readonly LedgerRow[];
  readonly total: Cost;
  /** How many of the effects that the scene calls for run. */
  readonly built: BuildUp;
  /** What the bars show. */
  readonly by: Measure;
  readonly times: Times | null;
  readonly kinds: readonly KindRow[];
  readonly saved: number;
  readonly cut: number;
  /** Pixels of the picture. */
  readonly pixels: number;
  readonly samples: number;
}

/** Work of one kind of ray, and how many each effect fired of them. */
export interface KindRow extends Work {
  readonly kind: RayKind;
  readonly parts: readonly { readonly words: string; readonly rays: number }[];
}

const NO_WORK: Work = { rays: 0, questions: 0, roots: 0 };
const NOTHING_SPENT: Cost = { ...NO_WORK, solves: 0, ms: 0 };
export const EMPTY_LEDGER: Ledger = {
  camera: NOTHING_SPENT,
  effects: {},
  kinds: { camera: NO_WORK, shadow: NO_WORK, reflected: NO_WORK, refracted: NO_WORK },
  fired: {},
  saved: 0,
  cut: 0,
};

interface LedgerView {
  readonly by?: Measure;
  readonly times?: Times | null;
  /** By forced effect, times of the picture in which it is as called for. */
  readonly unforced?: Readonly<Partial<Record<EffectId, Times | null | undefined>>>;
}

/** The ledger of a scene and its settings, with what has been measured so far. */
export function ledgerModel(
  scene: Scene,
  settings: TraceSettings,
  { camera, effects, kinds, fired, saved, cut }: Ledger,
  pixels: Readonly<Partial<Record<EffectId, number>>>,
  { by = 'questions', times = null, unforced = {} }: LedgerView = {},
): LedgerModel {
  const plan = planEffects(scene, settings.forced);
  const costs = plan.map(({ id }) => effects[id] ?? NOTHING_SPENT);
  const total = [camera, ...costs].reduce(sum, NOTHING_SPENT);
  const traced = camera.rays > 0;
  const amount = (id: EffectId | 'camera', cost: Cost): number =>
    by === 'ms' ? (times?.of[id]?.low ?? 0) : cost[by];
  const all =
    amount('camera', camera) +
    plan.reduce((sum, { id }, i) => sum + amount(id, costs[i] ?? NOTHING_SPENT), 0);
  const shareOf = (id: EffectId | 'camera', cost: Cost): number =>
    all > 0 ? amount(id, cost) / all : 0;
  let from = shareOf('camera', camera);
  const rows = plan.map((effect, i): LedgerRow => {
    const cost = costs[i] ?? NOTHING_SPENT;
    const share = effect.runs ? shareOf(effect.id, cost) : 0;
    const row = {
      ...effect,
      cost: traced && effect.runs ? cost : null,
      time: (effect.runs && times?.of[effect.id]) || null,
      unforced: (effect.forced !== 'no' && unforced[effect.id]) || null,
      share,
      from,
      pixels: pixels[effect.id] ?? null,
    };
    from += share;
    return row;
  });
  return {
    camera: {
      cost: traced ? camera : null,
      time: times?.of.camera ?? null,
      share: shareOf('camera', camera),
      from: 0,
      pixels: settings.width * settings.height,
    },
    simulated: rows.filter(({ runs }) => runs),
    idle: rows.filter(({ runs }) => !runs),
    total,
    built: buildUpOf(scene, settings.forced),
    by,
    times,
    kinds: kindRows(kinds, fired),
    saved,
    cut,
    pixels: settings.width * settings.height,
    samples: settings.samples,
  };
}

function kindRows(kinds: Ledger['kinds'], fired: Ledger['fired']): KindRow[] {
  return RAY_KINDS.map((kind) => ({
    kind,
    ...kinds[kind],
    parts: EFFECTS.flatMap(({ id, title, rays }) => {
      const count = fired[id]?.[kind];
      const words: Readonly<Partial<Record<RayKind, string>>> = rays;
      return count ? [{ words: words[kind] ?? `by ${title}`, rays: count }] : [];
    }),
  }));
}

const RAY_KINDS = ['camera', 'shadow', 'reflected', 'refracted'] as const;

const sum = (a: Cost, b: Cost): Cost => ({
  rays: a.rays + b.rays,
  questions: a.questions + b.questions,
  solves: a.solves + b.solves,
  roots: a.roots + b.roots,
  ms: a.ms + b.ms,
});

/**
 * The ledger as CSV, one effect per line, also those that did not run, with their reasons. Times
 * are the quartiles of repeats, of all workers; empty if they were not measured.
 */
export function ledgerCsv({ camera, simulated, idle, total, by, times }: LedgerModel): string {
  const costs = (cost: Cost | null, time: Spread | null): readonly Cell[] => [
    ...(cost ? [cost.rays, cost.questions, cost.solves, cost.roots] : [0, 0, 0, 0]),
    ...[time?.low, time?.high],
  ];
  const line = (row: LedgerRow): readonly Cell[] => [
    ...[row.id, row.leftOut ? 'left out' : row.needed, row.forced, row.reason],
    ...[...costs(row.cost, row.time), row.share, row.pixels],
  ];
  return csv([
    [
      ...['effect', 'needed', 'forced', 'reason', 'rays', 'questions', 'roots worked out'],
      ...['roots found', 'ms lower quartile', 'ms upper quartile', `share of ${by}`],
      'pixels changed',
    ],
    [
      'camera rays',
      true,
      'no',
      '',
      ...costs(camera.cost, camera.time),
      camera.share,
      camera.pixels,
    ],
    ...simulated.map(line),
    ...idle.map(line),
    ['picture', '', '', '', ...costs(total, times?.work ?? null), 1, ''],
  ]);
}

/** 1 491 968: groups of three, apart by a space that does not break. */
export function grouped(n: number): string {
  return String(n).replace(/\B(?=(\d{3})+$)/g, '\u202f');
}

/** Milliseconds with two digits, or as a whole number from 10 on: 0.42, 7.4, 1 005. */
export function msWords(ms: number): string {
  if (ms >= 10) return grouped(Math.round(ms));
  if (ms === 0) return '0';
  return ms < 0.005 ? '< 0.01' : ms.toFixed(ms >= 1 ? 1 : 2);
}

/** A share in percent; 0 % and 100 % are only shown for exactly none and all. */
export function percent(part: number, whole: number): string {
  if (whole === 0 || part === 0) return '0 %';
  const p = (100 * part) / whole;
  if (p < 0.05) return '< 0.1 %';
  if (p > 99.9 && part < whole) return '> 99.9 %';
  return `${p >= 99.95 ? '100' : p.toFixed(1)} %`;
}
