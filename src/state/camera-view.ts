/**
 * Where the camera stands: a named view, or angles in degrees about the stage's centre, with a zoom
 * factor or without.
 */
export type NamedView = 'iso' | 'top' | 'front' | 'side' | 'ray';

export interface FreeView {
  /** Degrees from the z axis towards x. */
  readonly azimuth: number;
  /** Degrees above the ground, −90 to 90. */
  readonly elevation: number;
  /** 1: the stage fills the frame; larger values are nearer. */
  readonly zoom: number;
}

/** Angles alone; zoom and shift are chosen so that everything is in the frame (framing.ts). */
interface AimedView extends Omit<FreeView, 'zoom'> {
  readonly zoom: null;
}

export type View = NamedView | FreeView | AimedView;

export const NAMED_VIEWS: readonly { readonly id: NamedView; readonly title: string }[] = [
  { id: 'iso', title: 'iso' },
  { id: 'top', title: 'top' },
  { id: 'front', title: 'front' },
  { id: 'side', title: 'side' },
  { id: 'ray', title: 'along ray' },
];

export const ZOOM_RANGE = { least: 0.2, most: 40 } as const;

export function isView(view: View): boolean {
  if (typeof view === 'string') return NAMED_VIEWS.some(({ id }) => id === view);
  const { azimuth, elevation, zoom } = view;
  return (
    Number.isFinite(azimuth) &&
    Math.abs(elevation) <= 90 &&
    (zoom === null || (zoom >= ZOOM_RANGE.least && zoom <= ZOOM_RANGE.most))
  );
}
