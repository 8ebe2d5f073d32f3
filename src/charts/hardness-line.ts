import { svg, type TemplateResult } from 'lit';
import { placeIn } from '../ui/zoom.ts';
import type {
  HardnessActions,
  HardnessLine,
  HardnessModel,
  HardnessScales,
} from './hardness-model.ts';
import type { LineStyle } from './line-style.ts';
import { type Field, px } from './plot.ts';

/** A method's line with its points, its end and its first failure; a slider for the keys. */
export function lineOf(
  line: HardnessLine,
  style: LineStyle,
  model: HardnessModel,
  { x, y }: HardnessScales,
  field: Field,
  actions: HardnessActions,
): TemplateResult {
  const at = line.points.map(({ difficulty, digits }) => [x(difficulty), y(digits)] as const);
  const path = at.map(([cx, cy], i) => `${i ? 'L' : 'M'}${px(cx)},${px(cy)}`).join('');
  const last = at.at(-1);
  const end = line.end && ([x(line.end.difficulty), y(0)] as const);
  const picked = model.picked?.id === line.id ? model.picked.difficulty : null;
  const here = line.points.findIndex(({ difficulty }) => difficulty === picked);
  const focus = picked === null ? (at[0] ?? end) : (at[here] ?? end);
  const cls = line.id === model.chosen ? 'is-chosen' : 'quiet';
  const first =
    line.first && line.points.find(({ difficulty }) => difficulty === line.first?.difficulty);
  return svg`<g class="plot-line" data-method=${line.id}
      role="slider" tabindex="0" aria-label=${line.name} aria-orientation="horizontal"
      aria-valuemin=${model.range[0]} aria-valuemax=${model.range[1]}
        aria-valuenow=${picked ?? model.range[0]}
      aria-valuetext=${wordsAt(line, picked ?? model.range[0])}
      @keydown=${(event: KeyboardEvent) => key(event, line, actions)}
      @click=${(event: MouseEvent) => click(event, model, { x, y }, actions)}>
    <path class=${`plot-path ${cls}`} stroke-dasharray=${style.dash} d=${path}></path>
    ${
      end && last
        ? svg`<path class=${`plot-fall ${cls}`}
      d=${`M${px(last[0])},${px(last[1])}L${px(end[0])},${px(end[1])}`}></path>`
        : ''
    }
    ${at.map(
      ([cx, cy]) => svg`<path class=${style.full ? 'plot-shape full' : 'plot-shape'}
      transform=${`translate(${px(cx)},${px(cy)}) scale(${field.mark})`} d=${style.shape}></path>`,
    )}
    ${
      end
        ? svg`<path class="plot-cross" transform=${`translate(${px(end[0])},${px(end[1])})`}
      d="M-4.5,-4.5L4.5,4.5M-4.5,4.5L4.5,-4.5"></path>`
        : ''
    }
    ${
      first
        ? svg`<path class="plot-first"
      transform=${`translate(${px(x(first.difficulty))},${px(y(first.digits))})`}
        d="M-3.5,-13L3.5,-6M-3.5,-6L3.5,-13"></path>`
        : ''
    }
    ${picked === null ? '' : pickedRing(line, picked, x, y, field)}
    <path class="plot-hit"
      d=${path + (end ? `${path ? 'L' : 'M'}${px(end[0])},${px(end[1])}` : '')}></path>
    ${
      focus
        ? svg`<circle class="plot-focus" cx=${px(focus[0])} cy=${px(focus[1])}
      r=${14 * field.mark}></circle>`
        : ''
    }
  </g>`;
}

function pickedRing(
  line: HardnessLine,
  picked: number,
  x: HardnessScales['x'],
  y: HardnessScales['y'],
  field: Field,
): TemplateResult {
  const point = line.points.find(({ difficulty }) => difficulty === picked);
  return svg`<circle class="plot-ring" cx=${px(x(picked))} cy=${px(y(point?.digits ?? 0))}
    r=${10 * field.mark}></circle>`;
}

/** The difficulties that can be picked on a line, ascending. */
const stops = ({ points, end }: HardnessLine): number[] => [
  ...points.map(({ difficulty }) => difficulty),
  ...(end ? [end.difficulty] : []),
];

function wordsAt(line: HardnessLine, difficulty: number): string {
  const point = line.points.find((one) => one.difficulty === difficulty);
  return point?.words ?? line.end?.words ?? line.points[0]?.words ?? 'no ray has a root';
}

function key(event: KeyboardEvent, line: HardnessLine, actions: HardnessActions): void {
  if (event.altKey || event.ctrlKey || event.metaKey) return;
  const all = stops(line);
  const last = actions.picked();
  const picked = last?.id === line.id ? last.difficulty : null;
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

/** Picks the stop that is nearest along the line that is nearest: their hit areas overlap. */
function click(
  event: MouseEvent,
  { lines }: HardnessModel,
  scales: HardnessScales,
  actions: HardnessActions,
): void {
  const root = (event.currentTarget as SVGElement).ownerSVGElement;
  if (!root) return;
  const at = placeIn(root, event);
  const [line] = [...lines].sort((a, b) => awayFrom(a, at, scales) - awayFrom(b, at, scales));
  if (!line) return;
  const aside = (difficulty: number): number => Math.abs(scales.x(difficulty) - at.x);
  const [nearest] = stops(line).sort((a, b) => aside(a) - aside(b));
  if (nearest !== undefined) actions.pick({ id: line.id, difficulty: nearest });
}

interface Point {
  readonly x: number;
  readonly y: number;
}

/** How far a place is from a line's points and the way between them, in px. */
function awayFrom({ points, end }: HardnessLine, at: Point, { x, y }: HardnessScales): number {
  const all = points.map(({ difficulty, digits }) => ({ x: x(difficulty), y: y(digits) }));
  if (end) all.push({ x: x(end.difficulty), y: y(0) });
  return Math.min(...all.map((a, i) => awayFromWay(a, all[i + 1] ?? a, at)));
}

function awayFromWay(a: Point, b: Point, at: Point): number {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const along = ((at.x - a.x) * dx + (at.y - a.y) * dy) / (dx * dx + dy * dy || 1);
  const share = Math.min(Math.max(along, 0), 1);
  return Math.hypot(at.x - a.x - share * dx, at.y - a.y - share * dy);
}
