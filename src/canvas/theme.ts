import { themed } from '../ui/themed.ts';

/** Colours of lines and surfaces; CSS uses the same custom properties for marks and labels. */
export type Ink = 'shape' | 'd' | 'hit' | 'normal' | 'ink3' | 'edge';

type Rgb = readonly [number, number, number];

/** Values of src/ui/tokens.css for the GPU. */
export interface Theme {
  readonly inks: Readonly<Record<Ink, Rgb>>;
  /** Background colour. */
  readonly scene: Rgb;
  /** Opacity of surfaces facing the eye, and at the silhouette. */
  readonly back: { readonly base: number; readonly rim: number };
  readonly front: { readonly base: number; readonly rim: number };
  /** Factor on every line and mark. */
  readonly scale: number;
  /** Size of a scene label in CSS pixels. */
  readonly label: number;
}

/**
 * The tokens' opacities were measured in linear light, and the GPU blends in sRGB, where the same
 * number covers more of a light ground and less of a dark one. With these factors the pixels are
 * those of the pictures.
 */
const WALLS_BY_DAY = 0.6;
const WALLS_BY_NIGHT = 1.1;

export function readTheme(element: Element): Theme {
  const style = getComputedStyle(element);
  const text = (name: string) => style.getPropertyValue(name).trim();
  const number = (name: string, otherwise: number) => Number.parseFloat(text(name)) || otherwise;
  const scene = rgb(text('--scene'));
  const walls = luminance(scene) > 0.5 ? WALLS_BY_DAY : WALLS_BY_NIGHT;
  return {
    scene,
    inks: {
      shape: rgb(text('--shape')),
      d: rgb(text('--d')),
      hit: rgb(text('--hit')),
      normal: rgb(text('--normal')),
      ink3: rgb(text('--ink3')),
      edge: rgb(text('--edge')),
    },
    back: { base: walls * number('--back-base', 0.1), rim: walls * number('--back-rim', 0.3) },
    front: { base: walls * number('--front-base', 0.13), rim: walls * number('--front-rim', 0.44) },
    scale: number('--mark-scale', 1),
    label: number('--scene-label', 23),
  };
}

function luminance([r, g, b]: Rgb): number {
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/**
 * Calls back when the theme around `place` changes, by attribute or by the system's setting.
 * Returns a function that stops it.
 */
export function onThemeChange(place: Element, changed: () => void): () => void {
  const observer = new MutationObserver(changed);
  observer.observe(themed(place), { attributeFilter: ['data-theme', 'class', 'style'] });
  const dark = matchMedia('(prefers-color-scheme: dark)');
  dark.addEventListener('change', changed);
  return () => {
    observer.disconnect();
    dark.removeEventListener('change', changed);
  };
}

/**
 * '#1c1f24', '#abc' or 'rgb(28, 31, 36)' → 0 … 1 in sRGB. Anything else is a middle grey, which
 * shows on every theme.
 */
function rgb(color: string): Rgb {
  const hex = /^#([\da-f]{3}|[\da-f]{6})$/i.exec(color)?.[1];
  const full = hex?.length === 3 ? hex.replace(/./g, '$&$&') : hex;
  const channels = full
    ? [0, 2, 4].map((i) => Number.parseInt(full.slice(i, i + 2), 16))
    : (/^rgba?\(([^)]*)\)$/.exec(color)?.[1]?.split(/[\s,/]+/) ?? []).slice(0, 3).map(Number);
  const [r = 128, g = 128, b = 128] = channels;
  return [r / 255, g / 255, b / 255];
}
