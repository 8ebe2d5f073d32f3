import { svg, type TemplateResult } from 'lit';
import type { HardnessLine, HardnessModel, HardnessScales } from './hardness-model.ts';
import { type Box, labelMarks, spread } from './mark-labels.ts';
import { type Field, fieldBox, labelSize, nameAt, px } from './plot.ts';

interface EndName {
  readonly line: HardnessLine;
  /** y in px of the line's end, and of its name. */
  readonly own: number;
  readonly at: number;
}

/**
 * The names of all lines: at the right for those that reach it, beside the cross for those that
 * end.
 */
export function lineNames(
  model: HardnessModel,
  scales: HardnessScales,
  field: Field,
): TemplateResult[] {
  const ends = endNames(model, scales, field);
  const taken = ends.map(({ line, at }) => ({
    left: nameLeft(field) - 2,
    top: at - 0.65 * field.em,
    ...labelSize(line.name, field.em),
  }));
  return [
    ...ends.map((end) => endName(end, model.chosen, field)),
    ...fallNames(model, scales, field, taken),
  ];
}

const nameLeft = ({ right, em }: Field): number => right + 1.4 * em;

/** Names beside the ends of the lines that reach the right edge, spread so as not to overlap. */
function endNames(model: HardnessModel, { y }: HardnessScales, field: Field): EndName[] {
  const reaching = model.lines.flatMap((line) => {
    const last = line.points.at(-1);
    return !line.end && last ? [{ line, own: y(last.digits) }] : [];
  });
  const at = spread(
    reaching.map(({ own }) => own),
    1.25 * field.em,
    field.top - field.em,
    field.bottom,
  );
  return reaching.map((one, i) => ({ ...one, at: at[i] ?? one.own }));
}

function endName({ line, own, at }: EndName, chosen: string, field: Field): TemplateResult {
  const cls = line.id === chosen ? 'plot-name is-chosen' : 'plot-name quiet';
  return svg`<line class="plot-leader" x1=${px(field.right + 5)}
    x2=${px(field.right + 1.1 * field.em)} y1=${px(own)} y2=${px(at)}></line>
    <text class=${cls} x=${px(nameLeft(field))} y=${px(at + 0.35 * field.em)}>${line.name}</text>`;
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

/** Names beside the cross of lines that end, a row for each, and one for the reason. */
function fallNames(
  model: HardnessModel,
  { x, y }: HardnessScales,
  field: Field,
  taken: readonly Box[],
): TemplateResult[] {
  const falls = fallsOf(model.lines);
  const frame: Box = { ...fieldBox(field), width: field.width - field.left - 4 };
  const rows = ({ lines, reason }: Fall): string[] => [...lines.map(({ name }) => name), reason];
  const wishes = falls.map((fall) => {
    const sizes = rows(fall).map((row) => labelSize(row, field.em));
    const width = Math.max(...sizes.map((size) => size.width));
    const height = sizes.reduce((sum, size) => sum + size.height, 0);
    return { x: x(fall.difficulty), y: y(0), radius: 6, width, height };
  });
  const places = labelMarks(wishes, frame, taken);
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
