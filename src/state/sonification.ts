import type { GraphModel } from './graph-model.ts';

/*
 * f along the ray as sound: t goes evenly from E to the end of the graph. f(t) is a pitch beside a
 * steady reference tone, which it equals where f is 0.
 */

/** The steady tone, Hz: A below middle C. */
export const REFERENCE_HZ = 220;
/** The pitch stays within so many octaves of it. */
const OCTAVES = 2;
/** Seconds for the whole way. */
const SECONDS = 6;
/** Changes of pitch in a second: more than can be heard one by one. */
const RATE = 40;
/** f at half of the octaves, as a part of the largest |f| that the graph shows. */
const HALF_WAY = 0.15;

/** Times are in seconds from the beginning. */
export interface Score {
  readonly seconds: number;
  /** t at the beginning and at the end. */
  readonly from: number;
  readonly to: number;
  /** What sounds, in order; between them is silence. Each has its pitch in Hz at some moments. */
  readonly tones: readonly {
    readonly begin: number;
    readonly end: number;
    readonly pitch: readonly { readonly at: number; readonly hertz: number }[];
  }[];
  readonly clicks: readonly number[];
}

/**
 * The pitch of a value of f in Hz: rising with f, the reference where f is 0, and within two
 * octaves of it however large f is. `half` is the |f| that is one octave away.
 */
export function pitchOf(f: number, half: number): number {
  const share = Number.isFinite(f) ? f / (Math.abs(f) + half) : Math.sign(f);
  return REFERENCE_HZ * 2 ** (OCTAVES * (share || 0));
}

/**
 * What is heard: a click at each hit, silence where the ray is inside. A flat shape has no inside;
 * its f is the signed distance to the plane times |N|, below the reference on the side that N
 * points away from.
 */
export function scoreOf(graph: GraphModel): Score {
  const { A, B, C, from, to, low, high, stretches, roots, caps } = graph;
  const start = from < 0 && to > 0 ? 0 : from;
  const seconds = SECONDS;
  const at = (t: number): number => (seconds * (t - start)) / (to - start);
  const half = HALF_WAY * Math.max(Math.abs(low), Math.abs(high), Number.MIN_VALUE);
  const f = (t: number): number => (A * t + B) * t + C;
  const audible = stretches
    .filter(({ place, to: end }) => place !== 'inside' && end > start)
    .map((stretch) => ({ begin: at(Math.max(stretch.from, start)), end: at(stretch.to) }));
  const tones = audible.map(({ begin, end }) => {
    const count = Math.max(2, Math.ceil(RATE * (end - begin)) + 1);
    const pitch = Array.from({ length: count }, (_, i) => {
      const share = i / (count - 1);
      const moment = begin + share * (end - begin);
      return { at: moment, hertz: pitchOf(f(start + (moment / seconds) * (to - start)), half) };
    });
    return { begin, end, pitch };
  });
  const clicks = [...roots, ...caps]
    .filter(({ role, t }) => role !== 'outside' && role !== 'cut' && t >= start && t <= to)
    .sort((a, b) => a.t - b.t)
    .map(({ t }) => at(t));
  return { seconds, from: start, to, tones, clicks };
}
