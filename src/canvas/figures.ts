import type { Vec3 } from '../math/index.ts';
import type { HitMark, SceneModel } from '../state/scene-model.ts';
import { NORMAL } from './framing.ts';
import { type Arrow, CLEAR, type Mark } from './marks.ts';
import {
  heading,
  isInside,
  type OffScreenPointer,
  pointerTo,
  visibleRay,
} from './off-screen-pointer.ts';
import type { Projection, ScreenPoint } from './projection.ts';
import { pointAt } from './ray.ts';
import { along, type StageUnits, unit } from './stage-units.ts';

/** A symbol to be written beside what it names. */
export interface Caption {
  readonly key: string;
  readonly symbol: string;
  readonly letter: string;
  readonly sub: string;
  /** Class that gives the colour. */
  readonly tone: 'E' | 'd' | 'shape' | 'hit' | 'rejected' | 'normal' | 'ghost' | 'words';
  readonly x: number;
  readonly y: number;
  readonly clear: number;
  /** Best direction of the label from its point, in radians, y down. */
  readonly angle: number;
}

export interface Figures {
  readonly marks: readonly Mark[];
  readonly arrows: readonly Arrow[];
  readonly captions: readonly Caption[];
  readonly pointers: readonly (OffScreenPointer &
    Pick<Caption, 'key' | 'symbol' | 'letter' | 'sub' | 'tone'>)[];
}

const UP_RIGHT = -Math.PI / 4;
const DOWN = Math.PI / 2;
/** Lengths of d in px at scale 1 below which its arrow head shrinks, and is not drawn. */
const HEAD_FULL = 40;
const HEAD_LEAST = 16;

type List<T> = T[];

/** Everything of fixed size above the lines, with its place on the screen and its symbol. */
export function figures(
  model: SceneModel,
  units: StageUnits,
  projection: Projection,
  scale: number,
): Figures {
  const all = {
    marks: [] as List<Mark>,
    arrows: [] as List<Arrow>,
    captions: [] as List<Caption>,
    pointers: [] as List<Figures['pointers'][number]>,
  };
  const see = (p: Vec3): ScreenPoint | null => seen(p, units, projection);

  addShape();
  addRay();
  // The first hit is drawn last, above the others.
  for (const hit of [...model.hits].sort((a, b) => rank(a) - rank(b))) addHit(hit);
  for (const { letter, index, at, direction, length } of model.arrows ?? []) {
    addNormal(`${letter}${index}`, `${letter}${index}`, String(index), at, direction, length);
  }
  const bead = model.bead?.drawn ? see(model.bead.point) : null;
  if (bead) all.marks.push({ key: 'bead', kind: 'bead', symbols: ['t'], spot: bead });
  return all;

  function addShape(): void {
    for (const { symbol, at } of model.drawing.marks) {
      const spot = see(at);
      if (!spot) continue;
      all.marks.push({ key: symbol, kind: 'point', symbols: [symbol], spot });
      all.captions.push({
        ...{ key: symbol, symbol, letter: symbol, sub: '', tone: 'shape' },
        ...{ x: spot.x, y: spot.y, clear: (CLEAR.point + 3) * scale, angle: 0 },
      });
    }
    model.drawing.normals.forEach(({ at, direction }, k) => {
      addNormal(`N of shape ${k}`, 'N', '', at, direction);
    });
  }

  function addRay(): void {
    const { origin, direction } = model.ray;
    const E = model.ray.originDrawn ? see(origin) : null;
    const name = { key: 'E', symbol: 'E', letter: 'E', sub: '', tone: 'E' } as const;
    if (E) {
      all.captions.push({ ...name, x: E.x, y: E.y, clear: CLEAR.E * scale, angle: UP_RIGHT });
    } else {
      all.pointers.push({ ...name, ...pointerTo(origin, 0, model, units, projection, scale) });
    }
    const tip = see(along(origin, direction, 1));
    const place = tip && units.toStage(along(origin, direction, 1));
    const course = place && heading(place, direction, projection);
    if (tip && course) {
      const length = E ? Math.hypot(tip.x - E.x, tip.y - E.y) / scale : HEAD_FULL;
      const size = Math.min(length / HEAD_FULL, 1);
      if (length >= HEAD_LEAST) {
        const turn = (Math.atan2(course[1], course[0]) * 180) / Math.PI;
        all.marks.push({ key: 'd', kind: 'head', symbols: ['d'], spot: tip, turn, size });
      }
    }
    addEnd();
    if (E) all.marks.push({ key: 'E', kind: 'E', symbols: ['E'], spot: E });
    // If the tip is not in the frame, d is written where the drawn ray ends or leaves the frame.
    const spot = tip ?? visibleRay(model, units, projection)?.end;
    if (!spot) return;
    const back = tip && course ? 9 * scale : 0;
    const [x, y] = course
      ? [spot.x - back * course[0], spot.y - back * course[1]]
      : [spot.x, spot.y];
    const angle = below(course);
    all.captions.push({
      ...{ key: 'd', symbol: 'd', letter: 'd', sub: '', tone: 'd' },
      ...{ x, y, clear: CLEAR.head * scale, angle },
    });
  }

  /** Adds the arrow at the far end of the drawn ray. */
  function addEnd(): void {
    const last = model.ray.segments.at(-1);
    const place = last && last.stretch !== 'behind' ? pointAt(model.ray, last.to, units) : null;
    const spot = place && projection.project(place);
    const course = place && heading(place, model.ray.direction, projection);
    if (!spot || !course || !isInside(spot, projection)) return;
    const turn = (Math.atan2(course[1], course[0]) * 180) / Math.PI;
    all.marks.push({ key: 'end', kind: 'end', symbols: ['d'], spot, turn });
  }

  function addHit(hit: HitMark): void {
    const n = String(hit.index);
    const tone = hit.role === 'first' || hit.role === 'other' ? 'hit' : 'rejected';
    const kind = tone === 'rejected' ? 'rejected' : hit.role === 'first' ? 'first' : 'other';
    const { letter = 't' } = hit;
    const root = `${letter}${n}`;
    const name = { key: root, symbol: root, letter, sub: n, tone } as const;
    const spot = hit.drawn ? see(hit.point) : null;
    if (!spot) {
      all.pointers.push({
        ...name,
        ...pointerTo(hit.point, hit.t, model, units, projection, scale),
      });
      return;
    }
    const point = letter === 't' ? `P${n}` : root;
    all.marks.push({ key: point, kind, symbols: [point, root], spot });
    const place = units.toStage(hit.point);
    const angle = below(place && heading(place, model.ray.direction, projection));
    const said = hit.words === undefined ? name : { ...name, letter: hit.words, sub: '' };
    all.captions.push({ ...said, x: spot.x, y: spot.y, clear: (CLEAR[kind] + 4) * scale, angle });
    if (hit.normal) {
      const sub = hit.words === undefined ? n : '';
      addNormal(`N${n}`, `N${n}`, sub, hit.point, hit.normal, hit.normalLength ?? null);
    }
  }

  /** `length` in world lengths; null for the one that shows a direction. */
  function addNormal(
    key: string,
    symbol: string,
    sub: string,
    at: Vec3,
    direction: Vec3,
    length: number | null = null,
  ): void {
    const place = units.toStage(at);
    const n = unit(direction);
    const from = place && projection.project(place);
    const long = length === null ? NORMAL : length / model.stage.radius;
    const to = place && n && projection.project(along(place, n, long));
    if (!from || !to || !isInside(from, projection)) return;
    all.arrows.push({ key, symbols: [symbol], from, to });
    const angle = Math.atan2(to.y - from.y, to.x - from.x);
    const letter = symbol.replace(/\d/, '');
    all.captions.push({
      ...{ key, symbol, letter, sub, tone: 'normal' },
      ...{ x: to.x, y: to.y, clear: 6 * scale, angle },
    });
  }
}

/** The place of a world point in the frame; null outside. */
export function seen(p: Vec3, units: StageUnits, projection: Projection): ScreenPoint | null {
  const place = units.toStage(p);
  const spot = place && projection.project(place);
  return spot && isInside(spot, projection) ? spot : null;
}

function rank(hit: HitMark): number {
  return hit.role === 'first' ? 1 : 0;
}

/** The angle orthogonal to the ray on its lower side. */
function below(course: readonly [number, number] | null): number {
  if (!course) return DOWN;
  const [x, y] = course[0] >= 0 ? course : [-course[0], -course[1]];
  return Math.atan2(x, -y);
}
