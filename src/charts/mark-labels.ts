/** A rectangle in px, y downwards. */
export interface Box {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** A mark that needs a label beside it. */
export interface LabelRequest {
  readonly x: number;
  readonly y: number;
  /** Radius of the mark in px. */
  readonly radius: number;
  readonly width: number;
  readonly height: number;
}

/** The place of a label, and whether it is so far from its mark that it needs a line to it. */
export interface PlacedLabel extends Box {
  readonly led: boolean;
}

/** Distance in px from a mark's edge to its label. */
const GAP = 6;
/** Grid in px of the places that are tried if all those beside the mark are taken. */
const STEP = 4;

/**
 * Places labels one after the other such that they do not overlap, cover no mark and none of the
 * `taken` boxes, and lie in the frame: beside the mark if that is free, else at the nearest free
 * place, with a line. Labels overlap only if the frame is too small for them. In the moving scene
 * canvas/labels.ts is used instead, which prefers small overlaps to jumps.
 */
export function labelMarks(
  wishes: readonly LabelRequest[],
  frame: Box,
  taken: readonly Box[] = [],
): PlacedLabel[] {
  const marks = wishes.map(({ x, y, radius: r }) => ({
    left: x - r - 1,
    top: y - r - 1,
    width: 2 * r + 2,
    height: 2 * r + 2,
  }));
  const placed: PlacedLabel[] = [];
  for (const wish of wishes) {
    const isFree = (box: Box): boolean =>
      isWithin(box, frame) && ![...placed, ...marks, ...taken].some((other) => overlap(box, other));
    const beside = besides(wish).find(isFree);
    const far = beside ?? nearest(wish, frame, isFree);
    placed.push({ ...(far ?? clamped(wish, frame)), led: !beside });
  }
  return placed;
}

/** The places beside a mark: right, left, above, below, and the corners. */
function besides({ x, y, radius, width, height }: LabelRequest): Box[] {
  const away = radius + GAP;
  const box = (left: number, top: number): Box => ({ left, top, width, height });
  const over = y - away - height + 2;
  const under = y + away - 2;
  return [
    box(x + away, y - height / 2),
    box(x - away - width, y - height / 2),
    box(x - width / 2, over),
    box(x - width / 2, under),
    box(x + radius, over),
    box(x + radius, under),
    box(x - radius - width, over),
    box(x - radius - width, under),
  ];
}

function nearest(wish: LabelRequest, frame: Box, isFree: (box: Box) => boolean): Box | null {
  const { x, y, width, height } = wish;
  let best: Box | null = null;
  let least = Number.POSITIVE_INFINITY;
  for (let top = frame.top; top + height <= frame.top + frame.height; top += STEP) {
    for (let left = frame.left; left + width <= frame.left + frame.width; left += STEP) {
      const far = Math.hypot(left + width / 2 - x, top + height / 2 - y);
      const box = { left, top, width, height };
      if (far < least && isFree(box)) {
        best = box;
        least = far;
      }
    }
  }
  return best;
}

function clamped({ x, y, radius, width, height }: LabelRequest, frame: Box): Box {
  const within = (at: number, from: number, to: number): number => Math.max(from, Math.min(at, to));
  return {
    left: within(x + radius + GAP, frame.left, frame.left + frame.width - width),
    top: within(y - height / 2, frame.top, frame.top + frame.height - height),
    width,
    height,
  };
}

const isWithin = (box: Box, frame: Box): boolean =>
  box.left >= frame.left &&
  box.top >= frame.top &&
  box.left + box.width <= frame.left + frame.width &&
  box.top + box.height <= frame.top + frame.height;

export const overlap = (a: Box, b: Box): boolean =>
  a.left < b.left + b.width &&
  b.left < a.left + a.width &&
  a.top < b.top + b.height &&
  b.top < a.top + a.height;

/**
 * Names under each other that want to stand at certain heights: moved apart as little as it takes,
 * their order kept.
 */
export function spread(
  heights: readonly number[],
  apart: number,
  top: number,
  bottom: number,
): number[] {
  const order = heights
    .map((_, i) => i)
    .sort((a, b) => (heights[a] as number) - (heights[b] as number) || a - b);
  const at = new Array<number>(heights.length);
  let below = top - apart;
  for (const i of order) {
    below = Math.max(heights[i] as number, below + apart);
    at[i] = below;
  }
  let above = bottom + apart;
  for (const i of order.reverse()) {
    above = Math.min(at[i] as number, above - apart);
    at[i] = above;
  }
  return at;
}
