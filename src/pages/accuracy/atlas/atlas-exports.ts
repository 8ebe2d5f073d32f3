import { mapPicture } from '../../../charts/failure-map.ts';
import type { Corners } from '../../../charts/map-gestures.ts';
import type { Border } from '../../../lab/atlas/borders.ts';
import type { MapFrame } from '../../../lab/atlas/frame.ts';
import { MARKS, TENTHS, VERDICTS } from '../../../lab/atlas/marks.ts';
import type { Probe } from '../../../lab/atlas/probe.ts';
import { scalesOf } from '../../../lab/atlas/request.ts';
import type { MapSummary } from '../../../lab/atlas/summary.ts';
import { casesAsTests, casesFile, casesOf } from '../../../lab/atlas/test-cases.ts';
import { PIXELS, SIDE } from '../../../lab/atlas/window.ts';
import type { AtlasMap } from '../../../state/accuracy/atlas.ts';
import {
  confirmedWords,
  mapSentence,
  markShares,
  placeWords,
} from '../../../state/accuracy/atlas-words.ts';
import { csv } from '../../../text/csv.ts';
import { displayAll, shortest } from '../../../text/format.ts';
import type { ExportItem } from '../../export-dialog.ts';

/** A map as it is shown. */
export interface ShownMap {
  readonly map: AtlasMap;
  /** Null while the window's first pixels are on their way. */
  readonly frame: MapFrame | null;
  readonly borders: readonly Border[];
  readonly summary: MapSummary | null;
  readonly probe: Probe | null;
}

/** The exports of the maps: pictures, numbers, and rays of the rectangle as test cases. */
export function atlasExports(
  shown: () => readonly ShownMap[],
  corners: () => Corners | null,
): ExportItem[] {
  const cases = (write: (cases: ReturnType<typeof casesOf>) => string) => (): string => {
    const [first] = shown();
    return first?.frame ? write(casesOf(first.map.request, first.frame, corners())) : '';
  };
  const text = (
    id: string,
    title: string,
    file: string,
    type: string,
    make: () => string,
  ): ExportItem => ({ id, title, file, type, text: make, blob: null });
  return [
    {
      id: 'map-png',
      title: 'map as PNG',
      file: 'graze-map.png',
      type: 'image/png',
      text: null,
      blob: async () => picture(shown()),
    },
    text('map-csv', 'map as CSV', 'graze-map.csv', 'text/csv', () => mapCsv(shown())),
    text('map-json', 'map as JSON', 'graze-map.json', 'application/json', () => json(shown())),
    text('map-cases', 'rays as cases', 'graze-cases.json', 'application/json', cases(casesFile)),
    text(
      'map-tests',
      'rays as tests',
      'graze-map.test.ts',
      'text/typescript',
      cases((all) => casesAsTests(all)),
    ),
  ];
}

/** One line per pixel: its two numbers, and the result of each map. */
function mapCsv(shown: readonly ShownMap[]): string {
  const [first] = shown;
  if (!first) return '';
  const [x, y] = scalesOf(first.map.request);
  const head = [
    ...['column', 'row', ...first.map.request.axes],
    ...shown.flatMap(({ map }) =>
      ['mark', 'said', 'right', 'digits lost'].map((one) => `${map.title}: ${one}`),
    ),
  ];
  const lines = Array.from({ length: PIXELS }, (_, pixel) => {
    const [column, row] = [pixel % SIDE, Math.floor(pixel / SIDE)];
    const own = shown.flatMap(({ frame, map }) =>
      cells(frame, pixel, map.request.start !== undefined),
    );
    return [column, row, x.numberAt(column), y.numberAt(row), ...own];
  });
  return csv([head, ...lines]);
}

function cells(frame: MapFrame | null, pixel: number, isLeaving: boolean): (string | number)[] {
  const mark = frame && MARKS[frame.marks[pixel] as number];
  if (!frame || !mark) return ['', '', '', ''];
  if (mark === 'nothing' || isLeaving) return [mark, '', '', ''];
  return [
    mark,
    VERDICTS[frame.said[pixel] as number] ?? '',
    VERDICTS[frame.truth[pixel] as number] ?? '',
    (frame.lost[pixel] as number) / TENTHS,
  ];
}

/** One letter per mark, in the order of MARKS; a row of pixels is a text, rows from the top. */
const LETTERS = '.mic?-';

function json(shown: readonly ShownMap[]): string {
  const maps = shown.map(({ map, frame, borders, summary, probe }) => ({
    title: map.title,
    isProgram: map.isOwn,
    request: map.request,
    words: words({ map, summary, probe }),
    summary,
    probe,
    letters: Object.fromEntries(MARKS.map((mark, i) => [LETTERS.charAt(i), mark])),
    rows: frame ? rowsOf(frame) : [],
    borders: borders.map(({ title, right, above }) => ({
      title,
      right: [...right],
      above: [...above],
    })),
  }));
  return `${JSON.stringify({ graze: 'failure-map', version: 1, side: SIDE, maps }, finite, 1)}\n`;
}

const finite = (_: string, value: unknown): unknown =>
  typeof value === 'number' && (!Number.isFinite(value) || Object.is(value, -0))
    ? shortest(value)
    : value;

function rowsOf({ marks }: MapFrame): string[] {
  return Array.from({ length: SIDE }, (_, i) => {
    const from = (SIDE - 1 - i) * SIDE;
    return Array.from(
      marks.subarray(from, from + SIDE),
      (mark) => LETTERS.charAt(mark) || ' ',
    ).join('');
  });
}

const words = ({ map, summary, probe }: Pick<ShownMap, 'map' | 'summary' | 'probe'>): string =>
  summary
    ? [
        mapSentence(map.title, summary, probe, map.request.start !== undefined),
        `${markShares(summary, map.request.start !== undefined).join('; ')}.`,
        placeWords(summary, map.request.start !== undefined),
        confirmedWords(probe),
      ]
        .filter(Boolean)
        .join(' ')
    : '';

const MAP = 1024;
const MARGIN = 40;
const LINE = 34;

/** The maps side by side with their sentences and axes, for print. */
function picture(shown: readonly ShownMap[]): Promise<Blob | null> {
  const canvas = document.createElement('canvas');
  const width = shown.length * (MAP + MARGIN) + MARGIN;
  canvas.width = width;
  canvas.height = MAP + 2 * MARGIN + 7 * LINE;
  const context = canvas.getContext('2d');
  if (!context || shown.length === 0) return Promise.resolve(null);
  context.fillStyle = '#ffffff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.fillStyle = '#000000';
  context.font = `24px ${getComputedStyle(document.body).fontFamily}`;
  shown.forEach(({ map, frame, borders, summary, probe }, i) => {
    const left = MARGIN + i * (MAP + MARGIN);
    const lines = wrapped(context, words({ map, summary, probe }) || map.title, MAP).slice(0, 4);
    lines.forEach((line, k) => {
      context.fillText(line, left, MARGIN + k * LINE);
    });
    const top = MARGIN + 4 * LINE;
    if (frame) context.putImageData(mapPicture(frame, borders, MAP), left, top);
    context.strokeRect(left, top, MAP, MAP);
    const { axes, at, measure, zoom } = map.request;
    const axis = (which: 0 | 1, arrow: string): string =>
      `${arrow} ${axes[which]}, in the middle ${displayAll(at[which])}`;
    context.fillText(axis(0, '→'), left, top + MAP + LINE);
    context.fillText(
      `${axis(1, '↑')}; ${measure}, zoom ${shortest(zoom)}`,
      left,
      top + MAP + 2 * LINE,
    );
  });
  return new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
}

function wrapped(context: CanvasRenderingContext2D, text: string, width: number): string[] {
  const lines: string[] = [];
  let line = '';
  for (const word of text.split(' ')) {
    const longer = line ? `${line} ${word}` : word;
    if (line && context.measureText(longer).width > width) {
      lines.push(line);
      line = word;
    } else line = longer;
  }
  return [...lines, line];
}
