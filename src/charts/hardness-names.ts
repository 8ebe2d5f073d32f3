import { svg, type TemplateResult } from 'lit';
import type { HardnessLine, HardnessModel, HardnessScales } from './hardness-model.ts';
import { type Box, placeLabels, spread } from './place-labels.ts';
import { type Field, fieldBox, labelSize, nameAt, px } from './plot.ts';

/** At the right, beside the ends of the lines that reach it. */
export function endNames(
  model: HardnessModel,
  { y }: HardnessScales,
  field: Field,
): TemplateResult[] {
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
export function fallNames(
  model: HardnessModel,
  { x, y }: HardnessScales,
  field: Field,
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
