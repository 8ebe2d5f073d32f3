import { type MapFrame, mapOf } from '../../../src/lab/atlas/frame.ts';
import { VERDICTS } from '../../../src/lab/atlas/marks.ts';
import { type Probe, probe, probeFor } from '../../../src/lab/atlas/probe.ts';
import { type MapRequest, scalesOf } from '../../../src/lab/atlas/request.ts';
import { type MapSummary, summaryOf } from '../../../src/lab/atlas/summary.ts';
import { SIDE } from '../../../src/lab/atlas/window.ts';
import { atlasOf } from '../../../src/state/accuracy/atlas.ts';
import { readAccuracy } from '../../../src/state/accuracy/settings.ts';
import type { AppState } from '../../../src/state/state.ts';

interface Seen {
  readonly request: MapRequest;
  readonly frame: MapFrame;
  readonly summary: MapSummary;
  readonly probe: Probe;
}

const known = new Map<string, Seen>();

/** The maps that a state of Accuracy shows. */
function mapsIn(state: AppState): Seen[] {
  const { values } = readAccuracy(state.settings.accuracy);
  return values.atlas === '' ? [] : atlasOf(state, values).maps.map(({ request }) => seen(request));
}

function seen(request: MapRequest): Seen {
  const key = JSON.stringify(request);
  const before = known.get(key);
  if (before) return before;
  const frame = mapOf(request);
  const summary = summaryOf(request, frame);
  const found = { request, frame, summary, probe: probe(probeFor(request, frame)) };
  known.set(key, found);
  return found;
}

/** The classes that there are in the upper left quarter, or in the lower right one. */
function classesIn({ truth }: MapFrame, upper: boolean): readonly (string | undefined)[] {
  const half = SIDE / 2;
  const pixels = [...truth.keys()].filter((pixel) => {
    const [column, row] = [pixel % SIDE, Math.floor(pixel / SIDE)];
    return upper ? column < half && row >= half : column > half && row < half - 1;
  });
  return [...new Set(pixels.map((pixel) => VERDICTS[truth[pixel] as number]))];
}

const isRight = ({ summary }: Seen): boolean => summary.counts.right === summary.rays;

type Check = (seen: Seen, what: string) => boolean;

const OF_A_MAP: readonly (readonly [RegExp, Check])[] = [
  [
    /^two above none$/,
    ({ frame }) =>
      classesIn(frame, true).join() === 'two' && classesIn(frame, false).join() === 'none',
  ],
  [/^wrong$/, ({ summary }) => summary.wrong > 0],
  [/^wrong in a tenth$/, ({ summary }) => 10 * summary.wrong > summary.rays],
  [/^right everywhere$/, (one) => isRight(one)],
  [/^never wrong$/, ({ summary }) => summary.wrong === 0],
  [/^cannot tell somewhere$/, ({ summary }) => summary.counts.undecided > 0],
  [/^only invents$/, ({ summary: { wrong, counts } }) => wrong > 0 && counts.invents === wrong],
  [/^along (.+)$/, ({ summary: { along } }, title) => along?.title === title && along.within < 20],
  [
    /^tears (.+)$/,
    ({ probe: { torn, looked } }, line) =>
      torn[0]?.line === line && torn[0].how === 'wrong' && torn[0].pixels === looked,
  ],
];

/** Whether a claim about the maps of a state holds; null for another kind of claim. */
export function holdsOnMaps(claim: string, state: AppState): boolean | null {
  const maps = mapsIn(state);
  if (maps.length === 0) return null;
  const far = /^E beyond (.+)$/.exec(claim);
  if (far) return Math.hypot(...state.E) > Number(far[1]);
  if (claim === 'a pixel is 1 double') {
    return maps.every(({ request }) =>
      scalesOf(request).every(({ step }) => step.by === 'doubles' && step.count === 1),
    );
  }
  if (claim === 'certified right everywhere') {
    const [first] = maps;
    return first !== undefined && isRight(seen({ ...first.request, method: 'exact' }));
  }
  const [, number, words = ''] = /^map (\d) (.+)$/.exec(claim) ?? [];
  const one = maps[Number(number) - 1];
  if (number === undefined || !one) return null;
  for (const [pattern, check] of OF_A_MAP) {
    const match = pattern.exec(words);
    if (match) return check(one, match[1] ?? '');
  }
  return null;
}
