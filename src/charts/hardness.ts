import { scaleLinear } from 'd3-scale';
import { html, render, svg, type TemplateResult } from 'lit';
import type { Mounted } from '../ui/mounted.ts';
import { type LineStyle, styleOf } from './line-style.ts';
import { type Box, placeLabels, spread } from './place-labels.ts';
import { axes, type Field, fieldBox, fieldOf, labelSize, nameAt, px } from './plot.ts';
import { watchMetrics } from './strip-metrics.ts';

export interface HardnessPoint {
  readonly difficulty: number;
  /** Right digits, 0 … 15.95. */
  readonly digits: number;
  readonly words: string;
}

export interface HardnessLine {
  readonly id: string;
  readonly name: string;
  readonly points: readonly HardnessPoint[];
  /** Where it ends, and why in a few words. */
  readonly end?: { readonly difficulty: number; readonly reason: string; readonly words: string };
  /** Where the first verdict is wrong or left open. */
  readonly first?: { readonly difficulty: number };
}

export interface HardnessModel {
  readonly lines: readonly HardnessLine[];
  readonly range: readonly [number, number];
  readonly dialTitle: string;
  readonly tick: (difficulty: number) => string;
  readonly digitsTitle: string;
  readonly chosen: string;
  readonly picked: Picked | null;
}

export interface Picked {
  readonly id: string;
  readonly difficulty: number;
}

export interface HardnessActions {
  pick(picked: Picked): void;
  open(picked: Picked): void;
}

/** Room at the right for the names of the lines, in em. */
const NAMES = 9.5;
const MOST = 16;

/** Right digits against difficulty, a line a method. */
export function mountHardness(host: HTMLElement, actions: HardnessActions): Mounted<HardnessModel> {
  let model: HardnessModel | null = null;
  host.classList.add('plot');
  const watch = watchMetrics(host, draw);

  function draw(): void {
    const metrics = watch.metrics();
    if (model && metrics) render(plot(model, fieldOf(metrics, NAMES), actions), watch.slot);
  }

  return {
    render(next) {
      model = next;
      draw();
    },
    dispose() {
      watch.dispose();
      host.classList.remove('plot');
    },
  };
}

interface Scales {
  readonly x: (difficulty: number) => number;
  readonly y: (digits: number) => number;
}

function plot(model: HardnessModel, field: Field, actions: HardnessActions): TemplateResult {
  const x = scaleLinear([...model.range], [field.left, field.right]);
  const y = scaleLinear([0, MOST], [field.bottom - 0.9 * field.em, field.top]);
  const scales = { x, y };
  const most = Math.max(3, Math.floor((field.right - field.left) / (5 * field.em)));
  const xTicks = x
    .ticks(most)
    .filter(Number.isInteger)
    .map((k) => ({ at: x(k), label: model.tick(k) }));
  const yTicks = [0, 4, 8, 12, 16].map((digits) => ({ at: y(digits), label: String(digits) }));
  const drawn = model.lines.map((line, i) => ({ line, style: styleOf(i) }));
  return html`<svg class="plot-svg" width=${field.width} height=${field.height} role="group" aria-label=${`${model.digitsTitle} against difficulty: ${model.dialTitle}`}>
    ${axes(field, { ticks: xTicks, title: `${model.dialTitle} →` }, { ticks: yTicks, title: model.digitsTitle })}
    ${drawn.map(({ line, style }) => lineOf(line, style, model, scales, field, actions))}
    ${names(model, scales, field)} ${fallNames(model, scales, field)}
  </svg>`;
}

function lineOf(
  line: HardnessLine,
  style: LineStyle,
  model: HardnessModel,
  { x, y }: Scales,
  field: Field,
  actions: HardnessActions,
): TemplateResult {
  const at = line.points.map(({ difficulty, digits }) => [x(difficulty), y(digits)] as const);
  const path = at.map(([cx, cy], i) => `${i ? 'L' : 'M'}${px(cx)},${px(cy)}`).join('');
  const last = at.at(-1);
  const end = line.end && ([x(line.end.difficulty), y(0)] as const);
  const cls = line.id === model.chosen ? 'is-chosen' : 'quiet';
  const picked = model.picked?.id === line.id ? model.picked.difficulty : null;
  const first =
    line.first && line.points.find(({ difficulty }) => difficulty === line.first?.difficulty);
  return svg`<g class="plot-line" data-method=${line.id}
      role="slider" tabindex="0" aria-label=${line.name} aria-orientation="horizontal"
      aria-valuemin=${model.range[0]} aria-valuemax=${model.range[1]} aria-valuenow=${picked ?? model.range[0]}
      aria-valuetext=${wordsAt(line, picked ?? model.range[0])}
      @keydown=${(event: KeyboardEvent) => key(event, line, picked, actions)}
      @click=${(event: MouseEvent) => click(event, line, x, actions)}>
    <path class=${`plot-path ${cls}`} stroke-dasharray=${style.dash} d=${path}></path>
    ${end && last ? svg`<path class=${`plot-fall ${cls}`} d=${`M${px(last[0])},${px(last[1])}L${px(end[0])},${px(end[1])}`}></path>` : ''}
    ${at.map(([cx, cy]) => svg`<path class=${style.full ? 'plot-shape full' : 'plot-shape'} transform=${`translate(${px(cx)},${px(cy)}) scale(${field.mark})`} d=${style.shape}></path>`)}
    ${end ? svg`<path class="plot-cross" transform=${`translate(${px(end[0])},${px(end[1])})`} d="M-4.5,-4.5L4.5,4.5M-4.5,4.5L4.5,-4.5"></path>` : ''}
    ${first ? svg`<path class="plot-first" transform=${`translate(${px(x(first.difficulty))},${px(y(first.digits))})`} d="M-3.5,-13L3.5,-6M-3.5,-6L3.5,-13"></path>` : ''}
    ${picked === null ? '' : pickedRing(line, picked, x, y, field)}
    <path class="plot-hit" d=${path + (end ? `${path ? 'L' : 'M'}${px(end[0])},${px(end[1])}` : '')}></path>
    ${last || end ? svg`<circle class="plot-focus" cx=${px((at[0] ?? end ?? [0, 0])[0])} cy=${px((at[0] ?? end ?? [0, 0])[1])} r="9"></circle>` : ''}
  </g>`;
}

function pickedRing(
  line: HardnessLine,
  picked: number,
  x: Scales['x'],
  y: Scales['y'],
  field: Field,
): TemplateResult {
  const point = line.points.find(({ difficulty }) => difficulty === picked);
  return svg`<circle class="plot-ring" cx=${px(x(picked))} cy=${px(y(point?.digits ?? 0))} r=${10 * field.mark}></circle>`;
}

/** Where a line can be asked, from left to right. */
const stops = ({ points, end }: HardnessLine): number[] => [
  ...points.map(({ difficulty }) => difficulty),
  ...(end ? [end.difficulty] : []),
];

function wordsAt(line: HardnessLine, difficulty: number): string {
  const point = line.points.find((one) => one.difficulty === difficulty);
  return point?.words ?? line.end?.words ?? line.points[0]?.words ?? 'no ray has a root';
}

function key(
  event: KeyboardEvent,
  line: HardnessLine,
  picked: number | null,
  actions: HardnessActions,
): void {
  if (event.altKey || event.ctrlKey || event.metaKey) return;
  const all = stops(line);
  const now = picked === null ? -1 : all.indexOf(picked);
  const to = {
    ArrowRight: now + 1,
    ArrowUp: now + 1,
    ArrowLeft: now - 1,
    ArrowDown: now - 1,
    Home: 0,
    End: all.length - 1,
  }[event.key];
  if (to !== undefined) {
    const difficulty = all[Math.max(0, Math.min(to, all.length - 1))];
    event.preventDefault();
    if (difficulty !== undefined) actions.pick({ id: line.id, difficulty });
  } else if (event.key === 'Enter' && picked !== null) {
    event.preventDefault();
    actions.open({ id: line.id, difficulty: picked });
  }
}

function click(
  event: MouseEvent,
  line: HardnessLine,
  x: Scales['x'],
  actions: HardnessActions,
): void {
  const root = (event.currentTarget as SVGElement).ownerSVGElement;
  if (!root) return;
  const at = event.clientX - root.getBoundingClientRect().left;
  const [nearest] = stops(line).sort((a, b) => Math.abs(x(a) - at) - Math.abs(x(b) - at));
  if (nearest !== undefined) actions.pick({ id: line.id, difficulty: nearest });
}

/** At the right, beside the ends of the lines that reach it. */
function names(model: HardnessModel, { y }: Scales, field: Field): TemplateResult[] {
  const reaching = model.lines.flatMap((line) => {
    const last = line.points.at(-1);
    return !line.end && last ? [{ line, y: y(last.digits) }] : [];
  });
  const apart = 1.25 * field.em;
  const at = spread(
    reaching.map((one) => one.y),
    apart,
    field.top - field.em,
    field.bottom,
  );
  return reaching.map(({ line, y: own }, i) => {
    const height = at[i] ?? own;
    const cls = line.id === model.chosen ? 'plot-name is-chosen' : 'plot-name quiet';
    return svg`<line class="plot-leader" x1=${px(field.right + 5)} x2=${px(field.right + 1.1 * field.em)} y1=${px(own)} y2=${px(height)}></line>
      <text class=${cls} x=${px(field.right + 1.4 * field.em)} y=${px(height + 0.35 * field.em)}>${line.name}</text>`;
  });
}

/** Lines that end at one place for one reason share their words. */
interface Fall {
  readonly difficulty: number;
  readonly reason: string;
  readonly lines: readonly HardnessLine[];
}

function fallsOf(lines: readonly HardnessLine[]): Fall[] {
  const found = new Map<string, { difficulty: number; reason: string; lines: HardnessLine[] }>();
  for (const line of lines) {
    if (!line.end) continue;
    const { difficulty, reason } = line.end;
    const key = `${difficulty} ${reason}`;
    const known = found.get(key);
    if (known) known.lines.push(line);
    else found.set(key, { difficulty, reason, lines: [line] });
  }
  return [...found.values()];
}

/** Beside the cross of lines that end, a row for each name and one for the reason. */
function fallNames(model: HardnessModel, { x, y }: Scales, field: Field): TemplateResult[] {
  const falls = fallsOf(model.lines);
  const frame: Box = { ...fieldBox(field), width: field.width - field.left - 4 };
  const rows = ({ lines, reason }: Fall): string[] => [...lines.map(({ name }) => name), reason];
  const wishes = falls.map((fall) => {
    const sizes = rows(fall).map((row) => labelSize(row, field.em));
    const width = Math.max(...sizes.map((size) => size.width));
    const height = sizes.reduce((sum, size) => sum + size.height, 0);
    return { x: x(fall.difficulty), y: y(0), radius: 6, width, height };
  });
  const places = placeLabels(wishes, frame);
  return falls.flatMap((fall, i) => {
    const place = places[i];
    const wish = wishes[i];
    if (!place || !wish) return [];
    const texts = rows(fall);
    const height = place.height / texts.length;
    return texts.map((text, k) => {
      const chosen = fall.lines[k]?.id === model.chosen;
      const row = {
        ...place,
        top: place.top + k * height,
        height,
        led: place.led && k === texts.length - 1,
      };
      return nameAt(text, row, wish, field.em, chosen ? 'is-chosen' : 'quiet');
    });
  });
}
