import type { MapAxis } from '../../lab/atlas/axes.ts';
import type { MapFrame } from '../../lab/atlas/frame.ts';
import { MARKS, type Mark, TENTHS, VERDICTS } from '../../lab/atlas/marks.ts';
import { type Probe, RIM, type Torn } from '../../lab/atlas/probe.ts';
import { type MapRequest, raysOf, scalesOf } from '../../lab/atlas/request.ts';
import type { MapSummary } from '../../lab/atlas/summary.ts';
import { type PixelStep, SIDE } from '../../lab/atlas/window.ts';
import { display, displayAll } from '../../text/format.ts';
import { SAYS } from './change-words.ts';

/** Words for a pixel with this mark. */
export const MARK_WORDS: Readonly<Record<Mark, string>> = {
  right: 'right',
  misses: 'misses a hit',
  invents: 'sees a hit that is not there',
  count: 'another number or kind of points',
  undecided: 'cannot tell',
  nothing: 'no such ray or shape',
};

/** The same for rays that leave their surface. */
export const LEAVING_WORDS: Readonly<Record<Mark, string>> = {
  ...MARK_WORDS,
  misses: 'loses its own surface, which is met again',
  invents: 'meets its own surface where it starts',
  nothing: 'meets nothing to leave from',
};

/** A share of pixels: every pixel, none, 4.5 %, 12 pixels. */
export function shareWords(count: number, of: number): string {
  if (count === of) return 'every pixel';
  if (count === 0) return 'none';
  const percent = (100 * count) / of;
  if (percent < 0.1) return `${count} ${count === 1 ? 'pixel' : 'pixels'}`;
  // 100 % would say that it is every pixel.
  if (percent > 99) return `${(Math.floor(10 * percent) / 10).toFixed(1)} %`;
  return `${percent < 10 ? percent.toFixed(1) : percent.toFixed(0)} %`;
}

/** Least number of lost digits, of 16, that a sentence mentions. */
const WORTH_TELLING = 1;

/** What share of the map is wrong, and which line tears. `title` begins the sentence. */
export function mapSentence(
  title: string,
  summary: MapSummary,
  probe: Probe | null,
  isLeaving: boolean,
): string {
  const { counts, rays, wrong, mostLost } = summary;
  const name = title.charAt(0).toUpperCase() + title.slice(1);
  if (rays === 0) return `${name}: there is no ray in this window to ask about.`;
  const of = isLeaving ? 'of the rays that leave' : 'of this window';
  const within = (count: number): string => {
    const share = shareWords(count, rays);
    return share.endsWith('%') ? `${share} ${of}` : share;
  };
  const tear = tearWords(probe);
  const open = counts.undecided > 0 ? `cannot tell in ${within(counts.undecided)}` : '';
  if (wrong > 0) {
    const more = open && `, and ${open}`;
    return `${name} is wrong in ${within(wrong)}${more}. ${tear}`.trimEnd();
  }
  if (open) return `${name} is never wrong here, and ${open}. ${tear}`.trimEnd();
  if (isLeaving) return `${name}: every ray that leaves meets what it should.`;
  const lost = Math.round(mostLost);
  const loses = lost >= WORTH_TELLING ? `, and loses up to ${lost} of 16 digits` : '';
  return `${name} has the right class in every pixel${loses}. ${tear}`.trimEnd();
}

/** The share of each mark that is there. */
export function markShares({ counts, rays }: MapSummary, isLeaving: boolean): readonly string[] {
  const words = isLeaving ? LEAVING_WORDS : MARK_WORDS;
  return MARKS.filter((mark) => mark !== 'nothing' && counts[mark] > 0).map(
    (mark) => `${words[mark]}: ${shareWords(counts[mark], rays)}`,
  );
}

function listed(all: readonly string[]): string {
  return all.length < 2 ? all.join('') : `${all.slice(0, -1).join(', ')} and ${all.at(-1)}`;
}

/** Which line of the derivation it is; '' while that is not known, or where there is none. */
function tearWords(probe: Probe | null): string {
  const [first] = probe?.torn ?? [];
  if (!probe || !first || first.line === '') return '';
  const { looked } = probe;
  const isAll = first.pixels === looked;
  const where = isAll ? `all ${looked}` : `${first.pixels} of ${looked}`;
  return TEARS[first.how](first, where);
}

const TEARS: Readonly<Record<Torn['how'], (torn: Torn, where: string) => string>> = {
  wrong: ({ line }, where) =>
    line === RIM
      ? `What tears is the comparison with the rim, in ${where} failing pixels looked at.`
      : `What tears is ${line}: its sign is wrong in ${where} failing pixels looked at.`,
  unknown: ({ line }, where) =>
    line === RIM
      ? `The comparison with the rim stays open, in ${where} failing pixels looked at.`
      : `The sign of ${line} stays open, in ${where} failing pixels looked at.`,
  digits: ({ line }, where) =>
    `They go in ${line}, in ${where} pixels looked at that lose the most.`,
};

/** A border in a sentence. */
const named = (title: string): string => (title === RIM ? 'the rim' : title);

/** Where the failing pixels lie, and along which border; '' if there are none. */
export function placeWords({ along, where, borders }: MapSummary, isLeaving: boolean): string {
  if (isLeaving) return where && `The failing pixels lie ${where}.`;
  if (where === '') {
    return borders.length > 0 ? `The window is crossed by ${listed(borders.map(named))}.` : '';
  }
  const near =
    along === null
      ? 'No border between classes crosses the window.'
      : along.within <= 1
        ? `9 of 10 of them lie right at ${named(along.title)}.`
        : `9 of 10 of them lie within ${along.within} pixels of ${named(along.title)}.`;
  return `The failing pixels lie ${where}. ${near}`;
}

/** What exact arithmetic confirmed; '' before. */
export const confirmedWords = (probe: Probe | null): string =>
  probe && probe.asked > 0
    ? `The verdicts to compare with are certified’s; exact arithmetic has the same in ` +
      `${probe.agreed} of ${probe.asked} pixels drawn from a seed.`
    : '';

const stepWords = (step: PixelStep): string => {
  if (step.by === 'doubles') {
    return step.count === 1 ? '1 double' : `${display(step.count, 3)} doubles`;
  }
  return step.by === 'lengths'
    ? display(step.size, 3)
    : `a factor of 1 + ${display(10 ** step.size - 1, 3)}`;
};

/** An axis: its number in the middle, how far it reaches, and what a pixel is. */
export function axisWords(axis: MapAxis, request: MapRequest, which: 0 | 1): string {
  const { at, step } = scalesOf(request)[which];
  const middle = `${axis.id} = ${displayAll(at)}`;
  const half = SIDE / 2;
  const reach =
    step.by === 'doubles'
      ? `± ${display(half * step.count, 3)} ${half * step.count === 1 ? 'double' : 'doubles'}`
      : step.by === 'lengths'
        ? `± ${display(half * step.size, 3)}`
        : `times 10^±${display(half * step.size, 3)}`;
  return `${middle} ${reach}`;
}

/** What a pixel is along an axis. */
export const pixelSize = (request: MapRequest, which: 0 | 1): string =>
  stepWords(scalesOf(request)[which].step);

/** The numbers of a pixel. */
export function numbersAt(request: MapRequest, column: number, row: number): string {
  const [x, y] = scalesOf(request);
  const [first, second] = request.axes;
  return `${first} = ${displayAll(x.numberAt(column))}, ${second} = ${displayAll(y.numberAt(row))}`;
}

/** What is said at a pixel, and what is right. */
export function saidAt(title: string, request: MapRequest, frame: MapFrame, pixel: number): string {
  const mark = MARKS[frame.marks[pixel] as number];
  if (!mark) return 'not there yet';
  if (request.start) return LEAVING_WORDS[mark];
  if (mark === 'nothing') return MARK_WORDS.nothing;
  const said = VERDICTS[frame.said[pixel] as number] ?? 'undecided';
  const truth = VERDICTS[frame.truth[pixel] as number] ?? 'undecided';
  if (mark !== 'right') {
    const right = SAYS[truth];
    return mark === 'undecided'
      ? `${title} cannot tell; right is “${right}”`
      : `${title} says “${SAYS[said]}”, right is “${right}”: ${MARK_WORDS[mark]}`;
  }
  const lost = (frame.lost[pixel] as number) / TENTHS;
  const digits = lost >= WORTH_TELLING ? `, ${Math.round(lost)} of 16 digits lost` : '';
  return `“${SAYS[said]}”, right${digits}`;
}

/** The map in words, for screen readers. */
export function mapDescription(
  title: string,
  request: MapRequest,
  axes: readonly [MapAxis, MapAxis],
  summary: MapSummary | null,
  probe: Probe | null,
): string {
  const window =
    `To the right ${axisWords(axes[0], request, 0)}, upwards ${axisWords(axes[1], request, 1)}. ` +
    `${SIDE} by ${SIDE} pixels.`;
  if (!summary) return window;
  const isLeaving = request.start !== undefined;
  const parts = [
    mapSentence(title, summary, probe, isLeaving),
    `${markShares(summary, isLeaving).join('; ')}.`,
    placeWords(summary, isLeaving),
    window,
  ];
  return parts.filter(Boolean).join(' ');
}

/** Ray and shape of a pixel as they would be typed; null where there are none. */
export const questionAt = (request: MapRequest, column: number, row: number) =>
  raysOf({ ...request, unit: false }).at(column, row);
