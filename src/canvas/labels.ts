/** A box by its centre, in CSS pixels. */
export interface Box {
  readonly x: number;
  readonly y: number;
  readonly w: number;
  readonly h: number;
}

export type Segment = readonly [x1: number, y1: number, x2: number, y2: number];

/** A label that wants to be near a mark, best in direction `angle` (radians, y down). */
interface LabelRequest {
  readonly key: string;
  readonly x: number;
  readonly y: number;
  /** Distance to keep from the mark's centre. */
  readonly clear: number;
  readonly angle: number;
  readonly w: number;
  readonly h: number;
}

export interface Obstacles {
  readonly boxes: readonly Box[];
  /** Boxes of labels that are placed already. */
  readonly labels?: readonly Box[];
  readonly segments: readonly Segment[];
  readonly width: number;
  readonly height: number;
}

/** Directions to try, in eighths of a turn from the best one, in the order of preference. */
const TURNS = [0, 1, -1, 2, -2, 3, -3, 4] as const;
const FRAME_MARGIN = 4;

/** Distances to try, beyond that beside the mark, as shares of the label's size. */
const STEPS = [0, 0.6, 1.3] as const;

// Costs, all in square pixels of hidden label.
const PER_TURN = 16;
const PER_STEP = 70;
const PER_SEGMENT_PIXEL = 10;
const PER_PIXEL_OUTSIDE = 60;
/** Overlapping labels are less readable than a label over a mark. */
const PER_LABEL_PIXEL = 20;
const ON_LABEL = 400;
/** Distance between labels in px: italic letters may lean out of their boxes. */
const GAP = 4;
/** Cost of moving a label, so that it jumps only to a clearly better place. */
const MOVE = 60;

/**
 * Places labels one after the other at the best of eight positions around their marks, or a step
 * away. `places` remembers the choice of each label from frame to frame and is updated. The same
 * wishes and memory give the same places.
 */
export function placeLabels(
  wishes: readonly LabelRequest[],
  { boxes, labels = [], segments, width, height }: Obstacles,
  places: Map<string, string>,
): Box[] {
  const placed = [...labels];
  return wishes.map((wish) => {
    let best = candidate(wish, 0, 0);
    let bestPlace = '';
    let least = Infinity;
    for (const step of STEPS) {
      for (const turn of TURNS) {
        const box = candidate(wish, turn, step);
        const place = `${turn} ${step}`;
        let cost = Math.abs(turn) * PER_TURN + step * PER_STEP;
        cost += PER_PIXEL_OUTSIDE * outside(box, width, height);
        if (places.has(wish.key) && places.get(wish.key) !== place) cost += MOVE;
        for (const other of boxes) cost += overlap(box, other);
        for (const other of placed) {
          const shared = overlap({ ...box, w: box.w + GAP, h: box.h + GAP }, other);
          if (shared > 0) cost += ON_LABEL + PER_LABEL_PIXEL * shared;
        }
        for (const segment of segments) cost += PER_SEGMENT_PIXEL * lengthInside(segment, box);
        if (cost < least) [best, bestPlace, least] = [box, place, cost];
      }
    }
    places.set(wish.key, bestPlace);
    placed.push(best);
    return best;
  });
}

/** The box that touches the circle around the mark, in a direction and at a distance. */
function candidate({ x, y, clear, angle, w, h }: LabelRequest, turn: number, step: number): Box {
  const a = angle + (turn * Math.PI) / 4;
  const [c, s] = [Math.cos(a), Math.sin(a)];
  const reach = clear + step * h + (Math.abs(c) * w + Math.abs(s) * h) / 2;
  return { x: x + reach * c, y: y + reach * s, w, h };
}

function outside({ x, y, w, h }: Box, width: number, height: number): number {
  const m = FRAME_MARGIN;
  return (
    Math.max(0, m - (x - w / 2)) +
    Math.max(0, x + w / 2 - width + m) +
    Math.max(0, m - (y - h / 2)) +
    Math.max(0, y + h / 2 - height + m)
  );
}

/** Area of the intersection of two boxes. */
export function overlap(a: Box, b: Box): number {
  const x = (a.w + b.w) / 2 - Math.abs(a.x - b.x);
  const y = (a.h + b.h) / 2 - Math.abs(a.y - b.y);
  return x > 0 && y > 0 ? Math.min(x, a.w, b.w) * Math.min(y, a.h, b.h) : 0;
}

/** Length of the part of a segment inside a box. */
function lengthInside(segment: Segment, box: Box): number {
  const span = spanInside(segment, box);
  if (!span) return 0;
  const [x1, y1, x2, y2] = segment;
  return (span[1] - span[0]) * Math.hypot(x2 - x1, y2 - y1);
}

/** The part of a segment inside a box, as shares of its length (Liang and Barsky's clipping). */
export function spanInside(
  [x1, y1, x2, y2]: Segment,
  { x, y, w, h }: Box,
): readonly [from: number, to: number] | null {
  const [dx, dy] = [x2 - x1, y2 - y1];
  let [from, to] = [0, 1];
  for (const [p, q] of [
    [-dx, x1 - (x - w / 2)],
    [dx, x + w / 2 - x1],
    [-dy, y1 - (y - h / 2)],
    [dy, y + h / 2 - y1],
  ] as const) {
    if (p === 0) {
      if (q < 0) return null;
    } else if (p < 0) from = Math.max(from, q / p);
    else to = Math.min(to, q / p);
  }
  return to > from ? [from, to] : null;
}
