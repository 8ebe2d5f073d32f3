import type { GraphModel } from '../../state/graph-model.ts';
import { REFERENCE_HZ, type Score, scoreOf } from '../../state/sonification.ts';
import { display } from '../../text/format.ts';
import type { Announce } from '../../ui/announcer.ts';
import { volume } from '../../ui/volume.ts';

/** Seconds before the sound begins, and of the fade of a tone, which would click without it. */
const LEAD = 0.15;
const FADE = 0.015;
/** A click: a decaying tone. */
const CLICK = { seconds: 0.03, hertz: 1800 } as const;
/** Amplitudes, as parts of the volume. */
const LOUD = { reference: 0.3, pitch: 0.4, click: 0.9 } as const;

export interface Sonification {
  readonly on: boolean;
  /** Lets the ray be heard once, or stops that. */
  toggle(graph: GraphModel): void;
  stop(): void;
}

/**
 * Plays f along the ray once, while `move` is told where it is, unless less motion is wanted. Any
 * key ends it and does nothing else; so does leaving the window or the tab. `changed` is called
 * when it begins or ends. Nothing runs while it is silent.
 */
export function createSonification(
  move: (t: number) => void,
  changed: () => void,
  announce: Announce,
): Sonification {
  let context: AudioContext | null = null;
  let ends = new AbortController();
  const stop = (): void => {
    if (!context) return;
    ends.abort();
    context.close().catch(() => {});
    context = null;
    changed();
  };
  const listen = (signal: AbortSignal): void => {
    const options = { signal, capture: true };
    const swallow = (event: Event): void => {
      event.preventDefault();
      event.stopImmediatePropagation();
      stop();
      announce('Stopped.', 'deed');
    };
    addEventListener('keydown', swallow, options);
    addEventListener('blur', stop, options);
    document.addEventListener('visibilitychange', stop, options);
  };
  const begin = (graph: GraphModel): void => {
    const score = scoreOf(graph);
    const sound = new AudioContext();
    context = sound;
    ends = new AbortController();
    listen(ends.signal);
    schedule(sound, score, volume(), sound.currentTime + LEAD);
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
    const began = sound.currentTime + LEAD;
    const follow = (): void => {
      if (context !== sound) return;
      const share = (sound.currentTime - began) / score.seconds;
      if (share >= 1) {
        stop();
        return;
      }
      if (!still && share > 0) move(score.from + share * (score.to - score.from));
      requestAnimationFrame(follow);
    };
    requestAnimationFrame(follow);
    announce(`The ray sounds from t ${display(score.from)} to ${display(score.to)}.`, 'deed');
    changed();
  };
  return {
    get on() {
      return context !== null;
    },
    toggle(graph) {
      if (context) stop();
      else begin(graph);
    },
    stop,
  };
}

/** Schedules tones and clicks on the context's clock, from `start` on, in seconds. */
function schedule(
  context: BaseAudioContext,
  { seconds, tones, clicks }: Score,
  loudness: number,
  start: number,
): void {
  const master = context.createGain();
  master.gain.value = loudness;
  master.connect(context.destination);
  for (const name of ['reference', 'pitch'] as const) {
    const gain = context.createGain();
    gain.gain.value = 0;
    gain.connect(master);
    const voice = context.createOscillator();
    voice.frequency.value = REFERENCE_HZ;
    voice.connect(gain);
    for (const { begin, end, pitch } of tones) {
      const fade = Math.min(FADE, (end - begin) / 3);
      gain.gain.setValueAtTime(0, start + begin);
      gain.gain.linearRampToValueAtTime(LOUD[name], start + begin + fade);
      gain.gain.setValueAtTime(LOUD[name], start + end - fade);
      gain.gain.linearRampToValueAtTime(0, start + end);
      if (name === 'reference') continue;
      for (const { at, hertz } of pitch) voice.frequency.setValueAtTime(hertz, start + at);
    }
    voice.start(start);
    voice.stop(start + seconds);
  }
  for (const at of clicks) click(context, master, start + at);
}

function click(context: BaseAudioContext, into: AudioNode, at: number): void {
  const { sampleRate } = context;
  const buffer = context.createBuffer(1, Math.ceil(CLICK.seconds * sampleRate), sampleRate);
  const samples = buffer.getChannelData(0);
  for (let i = 0; i < samples.length; i++) {
    const s = i / sampleRate;
    const fade = 1 - s / CLICK.seconds;
    samples[i] = LOUD.click * fade * Math.sin(2 * Math.PI * CLICK.hertz * s);
  }
  const source = context.createBufferSource();
  source.buffer = buffer;
  source.connect(into);
  source.start(at);
}
