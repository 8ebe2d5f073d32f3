import { NOTHING, type PixelWork, type TileResult } from '../tracer/types.ts';

/**
 * The picture so far. Coarse blocks are filled, so that it can be shown at any time. The arrays are
 * updated as tiles arrive.
 */
export interface Frame {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
  /** Surface and t (NaN: none) that each pixel's middle camera ray hit; valid for traced pixels. */
  readonly surface: Int32Array;
  readonly t: Float64Array;
  /** Size of the block that gave a pixel its colour; 0: the pixel was traced, 255: none yet. */
  readonly block: Uint8Array;
  /** Linear light, three doubles a pixel, if it was asked for; else null. */
  readonly film: Float64Array | null;
  /** What each pixel needed; valid for traced pixels. */
  readonly work: PixelWork;
}

/** A frame before tracing: transparent. */
export function newFrame(width: number, height: number, film = false): Frame {
  const pixels = width * height;
  return {
    width,
    height,
    rgba: new Uint8ClampedArray(4 * pixels),
    surface: new Int32Array(pixels).fill(NOTHING),
    t: new Float64Array(pixels).fill(Number.NaN),
    block: new Uint8Array(pixels).fill(255),
    film: film ? new Float64Array(3 * pixels) : null,
    work: {
      rays: new Uint32Array(pixels),
      questions: new Uint32Array(pixels),
      roots: new Uint32Array(pixels),
    },
  };
}

/**
 * Puts a tile into the picture. A pixel of a coarse pass fills its block. Tiles may arrive in any
 * order, so pixels that already have a finer colour are kept.
 */
export function paintTile(
  frame: Frame,
  { tile, pixels, rgba, surface, t, work, film }: TileResult,
): void {
  const { width, height, block } = frame;
  const { step } = tile;
  const colours = new Uint32Array(frame.rgba.buffer);
  const given = new Uint32Array(rgba.buffer, rgba.byteOffset, rgba.length / 4);
  for (let k = 0; k < pixels.length; k++) {
    const pixel = pixels[k] as number;
    frame.surface[pixel] = surface[k] as number;
    frame.t[pixel] = t[k] as number;
    if (film) frame.film?.set(film.subarray(3 * k, 3 * k + 3), 3 * pixel);
    frame.work.rays[pixel] = work.rays[k] as number;
    frame.work.questions[pixel] = work.questions[k] as number;
    frame.work.roots[pixel] = work.roots[k] as number;
    const x = pixel % width;
    const y = (pixel - x) / width;
    const right = Math.min(x + step, width);
    for (let row = y; row < Math.min(y + step, height); row++) {
      for (let at = row * width + x; at < row * width + right; at++) {
        if ((block[at] as number) < step) continue;
        colours[at] = given[k] as number;
        block[at] = step;
      }
    }
    colours[pixel] = given[k] as number;
    block[pixel] = 0;
  }
}
