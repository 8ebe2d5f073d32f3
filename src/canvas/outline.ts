import type { Drawing, Patch, PatchEnd } from '../math/drawing.ts';
import { type StageUnits, unit } from './stage-units.ts';
import { at, type Dash, type Stroke, straight } from './stroke.ts';
import { lineFade, pointOn } from './tessellation.ts';

const RING_STEPS = 144;
const SIDE_STEPS = 32;
const HAIRLINE = 1;
const RING_ALPHA = 0.38;
const AXIS = { width: 1.2, alpha: 0.62, dash: [11, 4] as Dash };
const GOES_ON_ALPHA = 0.7;

/** Line style of each kind of end of a patch; a point and a seam have no line. */
const ENDS: Partial<Record<PatchEnd, { width: number; alpha: number; dash: Dash | null }>> = {
  edge: { width: 2, alpha: 1, dash: null },
  rim: { width: 1.8, alpha: 1, dash: null },
  'goes-on': { width: 1.5, alpha: GOES_ON_ALPHA, dash: [7, 5] },
};

/** Lines of a drawing that do not depend on the view: rings, ends, helper lines; in stage units. */
export function outline(drawing: Drawing, units: StageUnits): Stroke[] {
  return [
    ...drawing.patches.flatMap((patch) => rings(patch, units)),
    ...drawing.lines.flatMap((line) => helper(line, units)),
    ...drawing.patches.flatMap((patch) => ends(patch, units)),
  ];
}

function rings(patch: Patch, units: StageUnits): Stroke[] {
  const style = { ink: 'shape', width: HAIRLINE, alpha: RING_ALPHA, dash: null } as const;
  const across = patch.rings.map((v) => ({ ...acrossAt(patch, v, units), ...style }));
  if (patch.closed) return across;
  // A flat patch has lines both ways, which show its tilt.
  return [...across, ...patch.rings.map((u) => ({ ...alongAt(patch, u, units), ...style }))];
}

function ends(patch: Patch, units: StageUnits): Stroke[] {
  const strokes: Stroke[] = [];
  for (const [v, end] of [
    [0, patch.start],
    [1, patch.end],
  ] as const) {
    const style = ENDS[end];
    // Dashes mean that the surface goes on; they do not fade with it.
    if (style) strokes.push({ ...acrossAt(patch, v, units), fade: null, ink: 'shape', ...style });
  }
  const style = ENDS[patch.sides];
  if (patch.closed || !style) return strokes;
  for (const u of [0, 1]) {
    strokes.push({ ...alongAt(patch, u, units), fade: null, ink: 'shape', ...style });
  }
  return strokes;
}

function helper(line: Drawing['lines'][number], units: StageUnits): Stroke[] {
  const from = units.toStage(line.from);
  const to = units.toStage(line.to);
  if (!from || !to || !unit([to[0] - from[0], to[1] - from[1], to[2] - from[2]])) return [];
  return [straight(from, to, { ink: 'shape', ...AXIS })];
}

type Curve = Pick<Stroke, 'points' | 'fade' | 'closed'>;

function acrossAt(patch: Patch, v: number, units: StageUnits): Curve {
  const steps = patch.closed ? RING_STEPS : SIDE_STEPS;
  // A closed ring leaves out u = 1, which is the same as u = 0.
  const count = patch.closed ? steps : steps + 1;
  return curve(count, patch.closed, units, patch, (k) => [k / steps, v]);
}

function alongAt(patch: Patch, u: number, units: StageUnits): Curve {
  return curve(SIDE_STEPS + 1, false, units, patch, (k) => [u, k / SIDE_STEPS]);
}

function curve(
  count: number,
  closed: boolean,
  units: StageUnits,
  patch: Patch,
  parameters: (k: number) => [u: number, v: number],
): Curve {
  const points: number[] = [];
  const fade: number[] = [];
  for (let k = 0; k < count; k++) {
    const [u, v] = parameters(k);
    const p = pointOn(patch, u, v, units);
    if (!p) continue;
    points.push(...p);
    fade.push(lineFade(patch, u, v));
  }
  return {
    points: Float64Array.from(points),
    fade: fade.some((f) => f < 1) ? Float64Array.from(fade) : null,
    closed: closed && at(points, 0) !== undefined,
  };
}
