import type { Output } from '../../../check/program/judge.ts';
import type { PackedCases } from '../../../check/program/protocol.ts';
import { asScript, looksTyped, tooLong } from '../../../check/program/script.ts';
import { textbookFor } from '../../../check/program/template.ts';
import { numberOn } from '../../../lab/atlas/axes.ts';
import { isWhole, type MapFrame, newMapFrame, paint, piecesOf } from '../../../lab/atlas/frame.ts';
import type { MapPart } from '../../../lab/atlas/map.ts';
import { lostDigits, markByte, markOf, VERDICTS } from '../../../lab/atlas/marks.ts';
import { type MapRequest, raysOf } from '../../../lab/atlas/request.ts';
import { summaryOf } from '../../../lab/atlas/summary.ts';
import { SIDE } from '../../../lab/atlas/window.ts';
import type { Question } from '../../../math/families.ts';
import { intersect, type Verdict } from '../../../math/index.ts';
import { displayAll } from '../../../text/format.ts';
import { lazy } from '../../../ui/lazy.ts';
import { openCheckStorage } from '../../check/check-storage.ts';
import { IGNORE_MESSAGES, runInSandbox } from '../../check/sandbox.ts';
import { EMPTY_MAP, type MapState, type mapJobs, sameMap } from './map-jobs.ts';

/** Words for a person who has no program. */
const NONE = 'There is no program of yours yet: write one on Check, under “own program”.';

/** The student's program, as Check keeps it; null and why, where it cannot be run. */
function program(): { readonly source: string | null; readonly why: string } {
  const source = openCheckStorage().program();
  if (source === null || source.trim() === '') return { source: null, why: NONE };
  const refusal = tooLong(source);
  return refusal
    ? { source: null, why: `Your program is not run: ${refusal}.` }
    : { source, why: '' };
}

/** The script that runs: TypeScript without its types, as on Check. */
async function scriptOf(source: string): Promise<string> {
  if (!looksTyped(source)) return asScript(source);
  const loaded = await lazy(() => import('../../../check/program/strip.ts')).catch(() => null);
  const stripped = loaded?.stripTypes(source);
  // Source that cannot be stripped runs as it is: the sandbox then reports its syntax error.
  return asScript(stripped?.ok ? stripped.text : source);
}

/** The class of a program's roots: the true one if it has as many roots, else the plain one. */
function verdictOf(output: Output, truth: Verdict): Verdict {
  if (output.type === 'shape') return 'undecided';
  const t = output.type === 'value' ? output.t : [];
  if (t.some(Number.isNaN)) return 'undecided';
  // A program that throws counts as one that returns no root.
  if (t.length === 0) return truth === 'contained' ? 'contained' : 'none';
  if (t.length === 1) return truth === 'tangent' ? 'tangent' : 'one';
  return t.length === 2 ? 'two' : 'undecided';
}

/**
 * Maps of the student's own program, which runs in the sandbox. `truth` draws certified's map
 * first, with which it is compared.
 */
export function ownMapJobs(
  host: HTMLElement,
  truthJobs: (changed: () => void) => ReturnType<typeof mapJobs>,
  changed: () => void,
) {
  let state: MapState = EMPTY_MAP;
  let close: (() => void) | null = null;
  let waits = false;
  /** A map may be cancelled while code for it is loaded: only the latest start counts. */
  let turn = 0;
  const put = (change: Partial<MapState>): void => {
    state = { ...state, ...change };
    changed();
  };
  const truth = truthJobs(() => {
    const { frame, summary, failed, request } = truth.state();
    if (!waits || request !== state.request) return;
    if (failed) {
      waits = false;
      put({ running: false, failed });
    } else if (summary && frame && request) {
      waits = false;
      void run(request, frame);
    }
  });

  function stop(): void {
    turn += 1;
    close?.();
    close = null;
    waits = false;
  }

  function start(request: MapRequest): void {
    stop();
    const { source, why } = program();
    put({ ...EMPTY_MAP, request, failed: why, running: source !== null });
    if (source === null) return;
    waits = true;
    truth.rest();
    truth.show(request);
  }

  async function run(request: MapRequest, known: MapFrame): Promise<void> {
    const { source } = program();
    if (source === null) return;
    const own = turn;
    const script = await scriptOf(source);
    if (own !== turn) return;
    const frame = newMapFrame();
    const asked = questionsOf(request, known);
    // Where there is no ray the program is not asked.
    for (const { block, pixels } of piecesOf(0, 1)) {
      for (const pixel of pixels) {
        if (known.marks[pixel] === markByte('nothing')) paint(frame, partAt(known, pixel), block);
      }
    }
    const share = (): number => frame.done / frame.marks.length;
    const textbook = textbookFor([request.shape.kind], 'textbook');
    const packed = packedCases(request, asked);
    const job = { source: script, textbook, cases: [], timed: [], packed };
    close = runInSandbox(host, job, {
      ...IGNORE_MESSAGES,
      output(index, output) {
        const one = asked[index];
        if (!one) return;
        paint(frame, judged(known, one, output), one.block);
        if (index % SHOWN_EVERY === 0) put({ frame, shown: request, share: share() });
      },
      unsteady: () => put({ failed: 'Run twice, your program gave two results for one ray.' }),
      end(ending) {
        close = null;
        if (isWhole(frame)) {
          const summary = summaryOf(request, frame);
          put({ running: false, frame, shown: request, share: 1, summary });
          return;
        }
        const message = ending.how === 'done' ? 'it ended too soon' : ending.message;
        put({ running: false, share: share(), failed: `Your program stopped: ${message}.` });
      },
    });
  }

  return {
    state: () => state,
    show(request: MapRequest): void {
      if (!sameMap(state.request, request)) start(request);
    },
    again(): void {
      if (state.request) start(state.request);
    },
    cancel(): void {
      stop();
      truth.cancel();
      put({ running: false });
    },
    rest(): void {
      stop();
      truth.rest();
      if (state.running) state = { ...state, running: false, request: null };
    },
  };
}

/** Number of outputs from one drawing of the map to the next. */
const SHOWN_EVERY = 512;

interface Asked {
  readonly pixel: number;
  readonly block: number;
  readonly question: Question;
}

/** The pixels that have a ray, coarse to fine. */
function questionsOf(request: MapRequest, known: MapFrame): Asked[] {
  const rays = raysOf(request);
  const asked: Asked[] = [];
  for (const { block, pixels } of piecesOf(0, 1)) {
    for (const pixel of pixels) {
      if (known.marks[pixel] === markByte('nothing')) continue;
      const question = rays.at(pixel % SIDE, Math.floor(pixel / SIDE));
      if (question) asked.push({ pixel, block, question });
    }
  }
  return asked;
}

/** The cases as an array of numbers: as objects they would make too large a message. */
function packedCases(request: MapRequest, asked: readonly Asked[]): PackedCases {
  const own = raysOf(request).axes.filter((axis) => axis.of === 'shape');
  const stride = 6 + own.length;
  const numbers = new Float64Array(asked.length * stride);
  asked.forEach(({ question }, i) => {
    const { origin, direction } = question.ray;
    numbers.set(
      [...origin, ...direction, ...own.map((axis) => numberOn(axis, question))],
      i * stride,
    );
  });
  return { shape: request.shape, paths: own.map(({ key, index }) => [key, index]), numbers };
}

/** One pixel of a whole frame. */
function partAt(frame: MapFrame, pixel: number): MapPart {
  const byte = (from: Uint8Array): Uint8Array => from.slice(pixel, pixel + 1);
  return {
    pixels: Int32Array.of(pixel),
    marks: byte(frame.marks),
    lost: byte(frame.lost),
    said: byte(frame.said),
    truth: byte(frame.truth),
    leading: byte(frame.leading),
  };
}

/** A pixel with what the program said in place of certified. */
function judged(known: MapFrame, { pixel, question }: Asked, output: Output): MapPart {
  const truth = VERDICTS[known.truth[pixel] as number] ?? 'none';
  const said = verdictOf(output, truth);
  const mark = markOf(said, truth);
  const own = output.type === 'value' ? [...output.t].sort((a, b) => a - b) : [];
  const { shape, ray } = question;
  const roots = mark === 'right' ? intersect(shape, ray).hits.map(({ t }) => t) : [];
  return {
    ...partAt(known, pixel),
    marks: Uint8Array.of(markByte(mark)),
    said: Uint8Array.of(VERDICTS.indexOf(said)),
    lost: Uint8Array.of(lostDigits(own, roots)),
  };
}

/** Runs the student's program on one ray and says what it answers. */
export async function tryProgram(
  host: HTMLElement,
  question: Question,
  tell: (words: string) => void,
): Promise<void> {
  const { source, why } = program();
  if (source === null) {
    tell(why);
    return;
  }
  tell('Your program is running …');
  const { shape, ray } = question;
  const truth = intersect(shape, ray);
  const script = await scriptOf(source);
  let said = 'Your program gave no answer.';
  runInSandbox(
    host,
    {
      source: script,
      textbook: textbookFor([shape.kind], 'textbook'),
      cases: [question],
      timed: [],
    },
    {
      ...IGNORE_MESSAGES,
      output(_, output) {
        said = answerWords(
          output,
          truth.class,
          truth.hits.map(({ t }) => t),
        );
      },
      end(ending) {
        tell(ending.how === 'done' ? said : `Your program stopped: ${ending.message}.`);
      },
    },
  );
}

function answerWords(output: Output, truth: Verdict, roots: readonly number[]): string {
  const right = roots.length > 0 ? `t = ${roots.map(displayAll).join(', ')}` : 'no root';
  if (output.type === 'threw') return `Your program throws: ${output.message}. Right is ${right}.`;
  if (output.type === 'shape') return `Your program ${output.message}. Right is ${right}.`;
  if (output.type !== 'value') return 'Your program gave no answer.';
  const own = output.t.length > 0 ? `t = ${output.t.map(displayAll).join(', ')}` : 'no root';
  const mark = markOf(verdictOf(output, truth), truth);
  const other = mark === 'right' ? '' : ', another count';
  return `Your program answers ${own}; right is ${right}${other}.`;
}
