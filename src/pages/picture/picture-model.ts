import { METHODS } from '../../math/index.ts';
import { EFFECTS, type EffectId } from '../../scene/effects/index.ts';
import {
  EMPTY_LEDGER,
  type LedgerModel,
  ledgerModel,
  type Measure,
} from '../../state/picture/ledger.ts';
import { type PictureSettings, pictureSettings } from '../../state/picture/settings.ts';
import type { Times } from '../../state/picture/times.ts';
import type { AppState } from '../../state/state.ts';
import { type Comparison, comparePictures } from '../../tracer/compare.ts';
import type { Frame, TraceProgress } from '../../workers/trace-job.ts';
import type { TraceQueue } from './trace-queue.ts';
import { type TraceRequest, type TraceRequests, traceRequests } from './trace-request.ts';

/** What the page shows: its settings, and the progress of each of their pictures. */
export interface PictureModel {
  readonly picture: PictureSettings;
  readonly requests: TraceRequests;
  readonly main: TraceProgress | null;
  readonly other: TraceProgress | null;
  /** Comparison with the side of the more accurate method, once both are finished. */
  readonly comparison: Comparison | null;
  /** Whether the left side has the more accurate method. */
  readonly trustsLeft: boolean;
  readonly ledger: LedgerModel;
  /** The ledger of the other side; null before that is finished. */
  readonly otherLedger: LedgerModel | null;
  /** Pictures that the ledger's last column would still need. */
  readonly uncounted: readonly TraceRequest[];
}

/** The measure of the ledger's bars, and measured times; neither is part of the state. */
export interface PictureVisit {
  readonly by: Measure;
  times(request: TraceRequest): Times | null;
}

const NO_VISIT: PictureVisit = { by: 'questions', times: () => null };

export function pictureModel(
  state: AppState,
  traceQueue: TraceQueue,
  visit: PictureVisit = NO_VISIT,
  picture = pictureSettings(state.settings.picture),
): PictureModel {
  const requests = traceRequests(picture, state.method);
  const main = traceQueue.seen(requests.main);
  const other = requests.other && traceQueue.seen(requests.other);
  const trustsLeft =
    picture.against?.change === 'whole' ||
    trustOf(requests.other ?? requests.main) > trustOf(requests.main);
  const times = visit.times(requests.main);
  // A picture without measured times has bars of questions.
  const by = visit.by === 'ms' && !times ? 'questions' : visit.by;
  const counts: Partial<Record<EffectId, number>> = {};
  const uncounted: TraceRequest[] = [];
  for (const { id } of EFFECTS) {
    const toggled = requests.toggled[id];
    const found = toggled && compared(traceQueue.seen(toggled), main);
    if (found) counts[id] = found.differing;
    else if (toggled && runsIn(requests, id)) uncounted.push(toggled);
  }
  return {
    picture,
    requests,
    main,
    other,
    comparison: trustsLeft ? compared(main, other) : compared(other, main),
    trustsLeft,
    ledger: ledgerModel(
      picture.scene,
      requests.main.settings,
      main?.ledger ?? EMPTY_LEDGER,
      counts,
      {
        by,
        times,
        unforced: mapped(requests.toggled, (request) => request && visit.times(request)),
      },
    ),
    otherLedger:
      requests.other && other?.state === 'finished'
        ? ledgerModel(
            picture.scene,
            requests.other.settings,
            other.ledger,
            {},
            {
              by,
              times: visit.times(requests.other),
            },
          )
        : null,
    uncounted,
  };
}

const mapped = <A, B>(
  of: Readonly<Partial<Record<EffectId, A>>>,
  change: (a: A | undefined) => B,
): Partial<Record<EffectId, B>> =>
  Object.fromEntries(EFFECTS.map(({ id }) => [id, change(of[id])]));

/** Index of the method in METHODS, which are ordered by accuracy. */
const trustOf = ({ settings }: TraceRequest): number =>
  METHODS.findIndex(({ id }) => id === settings.method);

/** An effect that the other picture lacks runs in this one. */
const runsIn = ({ toggled }: TraceRequests, id: EffectId): boolean =>
  toggled[id]?.settings.forced[id] === 'off';

const known = new WeakMap<Frame, WeakMap<Frame, Comparison>>();

/** The result is cached: every progress message of another picture asks for it again. */
function compared(a: TraceProgress | null, b: TraceProgress | null): Comparison | null {
  if (a?.state !== 'finished' || b?.state !== 'finished') return null;
  const mine = known.get(a.frame) ?? new WeakMap<Frame, Comparison>();
  known.set(a.frame, mine);
  const found = mine.get(b.frame) ?? comparePictures(a.frame, b.frame);
  mine.set(b.frame, found);
  return found;
}
