import { createMapper, type MapPart } from './map.ts';
import { PENDING } from './marks.ts';
import type { MapRequest } from './request.ts';
import { PIXELS, SIDE } from './window.ts';

/** A map so far. Coarse blocks are filled, so that it can be looked at at any time. */
export interface MapFrame {
  readonly marks: Uint8Array;
  readonly lost: Uint8Array;
  readonly said: Uint8Array;
  readonly truth: Uint8Array;
  readonly leading: Uint8Array;
  /** Side of the block that gave a pixel its bytes: 1 for one that was asked itself. */
  readonly block: Uint8Array;
  /** Pixels that were asked themselves. */
  done: number;
}

export function newMapFrame(): MapFrame {
  const bytes = (value = 0): Uint8Array => new Uint8Array(PIXELS).fill(value);
  return {
    marks: bytes(PENDING),
    lost: bytes(),
    said: bytes(),
    truth: bytes(),
    leading: bytes(1),
    block: bytes(255),
    done: 0,
  };
}

export const isWhole = ({ done }: MapFrame): boolean => done === PIXELS;

/** Sides of the blocks, pass by pass, coarse to fine. */
const BLOCKS = [8, 4, 2, 1] as const;
const BAND = BLOCKS[0];
/** Pixels asked about at a time: few enough to cancel soon, enough for kernels to be fast. */
const AT_A_TIME = 4096;

/** A piece of a map's work: pixels of one pass. */
interface Piece {
  readonly block: number;
  readonly pixels: Int32Array;
}

/**
 * The pieces of one of `parts` workers, coarse to fine: bands of rows are dealt out in turn, so
 * that every part has its share of each region. Each pixel is in one piece of one part.
 */
export function* piecesOf(part: number, parts: number): Generator<Piece, void> {
  for (const block of BLOCKS) {
    let pixels: number[] = [];
    for (let row = 0; row < SIDE; row += block) {
      if (Math.floor(row / BAND) % parts !== part) continue;
      for (let column = 0; column < SIDE; column += block) {
        const isKnown = block < BAND && row % (2 * block) === 0 && column % (2 * block) === 0;
        if (!isKnown) pixels.push(row * SIDE + column);
      }
      if (pixels.length >= AT_A_TIME) {
        yield { block, pixels: Int32Array.from(pixels) };
        pixels = [];
      }
    }
    if (pixels.length > 0) yield { block, pixels: Int32Array.from(pixels) };
  }
}

/** Puts pixels of a pass into the frame; finer ones that are there already stay. */
export function paint(frame: MapFrame, part: MapPart, block: number): void {
  const { pixels } = part;
  for (let k = 0; k < pixels.length; k++) {
    const pixel = pixels[k] as number;
    const column = pixel % SIDE;
    const first = pixel - column;
    for (let row = 0; row < block; row++) {
      for (let i = 0; i < block; i++) {
        const at = first + row * SIDE + column + i;
        if (at !== pixel && (frame.block[at] as number) < block) continue;
        frame.marks[at] = part.marks[k] as number;
        frame.lost[at] = part.lost[k] as number;
        frame.said[at] = part.said[k] as number;
        frame.truth[at] = part.truth[k] as number;
        frame.leading[at] = part.leading[k] as number;
        frame.block[at] = at === pixel ? 1 : block;
      }
    }
    frame.done += 1;
  }
}

/** The whole map at once, for tests, exports and the bench. */
export function mapOf(request: MapRequest): MapFrame {
  const mapper = createMapper(request);
  const frame = newMapFrame();
  for (const { block, pixels } of piecesOf(0, 1)) paint(frame, mapper.part(pixels), block);
  return frame;
}
