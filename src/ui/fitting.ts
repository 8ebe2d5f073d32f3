import { CERTAIN_DIGITS, display, MINUS } from '../text/format.ts';

let context: CanvasRenderingContext2D | null = null;

/** The width in px of a text in a font. */
function widthOf(text: string, font: string): number {
  context ??= document.createElement('canvas').getContext('2d');
  if (!context) return 0;
  if (context.font !== font) context.font = font;
  return context.measureText(text).width;
}

/** A number as text for a box of `room` px: all digits, or fewer with ≈ before. */
export function fitting(x: number, room: number, font: string): string {
  if (room <= 0) return display(x);
  return shortened(x, (text) => widthOf(text, font) <= room);
}

/** The number in up to six digits that fit, with ≈ before a rounded one; '≈…' if none fit. */
export function shortened(x: number, fits: (text: string) => boolean): string {
  const whole = display(x, CERTAIN_DIGITS);
  const marked = (text: string, digits: number): string => {
    const isWhole = display(Number(x.toPrecision(digits)), CERTAIN_DIGITS) === whole;
    return `${isWhole ? '' : '≈'}${text}`;
  };
  for (const n of [6, 5, 4, 3, 2, 1]) {
    const text = marked(display(x, n).replaceAll(' ', ''), n);
    if (fits(text)) return text;
  }
  // An exponent as e7 is narrower than 10⁷.
  for (const n of [3, 2, 1]) {
    const text = marked(x.toExponential(n - 1).replaceAll('-', MINUS), n);
    if (fits(text)) return text;
  }
  return '≈…';
}
