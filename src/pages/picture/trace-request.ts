import { EFFECTS, type EffectId } from '../../scene/effects/index.ts';
import { planEffects } from '../../scene/effects/plan.ts';
import type { Scene } from '../../scene/types.ts';
import { otherSide } from '../../state/picture/comparison.ts';
import type { PictureSettings } from '../../state/picture/settings.ts';
import type { TraceSettings } from '../../tracer/types.ts';
import { MOST_BOUNCES } from '../../tracer/weight.ts';

/** A picture to trace. Equal keys mean equal pictures, bit for bit. */
export interface TraceRequest {
  readonly key: string;
  readonly scene: Scene;
  readonly settings: TraceSettings;
  /** Whether there is no coarse picture first. */
  readonly atOnce?: boolean;
}

export interface TraceRequests {
  readonly main: TraceRequest;
  /** The other picture of the comparison; null without one. */
  readonly other: TraceRequest | null;
  /** By effect, the picture in which that effect is as it is not in the main one. */
  readonly toggled: Readonly<Partial<Record<EffectId, TraceRequest>>>;
  /** Of those, the ones that the ledger needs for what was forced. */
  readonly baselines: readonly TraceRequest[];
}

/** Most forced effects for which the picture without forcing is traced by itself. */
const MOST_BASELINES = 2;

export function traceRequests(picture: PictureSettings, method: string): TraceRequests {
  const { scene, sceneText, width, height, samples, lightSamples, start, forced } = picture;
  const settings: TraceSettings = {
    ...{ width, height, samples, lightSamples, method, start, forced },
    // Left out at its largest value, so that keys of pictures stay the same.
    ...(picture.bounces < MOST_BOUNCES ? { bounces: picture.bounces } : {}),
  };
  const request = (changed: TraceSettings): TraceRequest => ({
    key: JSON.stringify([sceneText, { ...changed, forced: differing(scene, changed) }]),
    scene,
    settings: changed,
  });
  const plan = planEffects(scene, forced);
  const toggled = plan.map(({ id, runs, forced: how }) => {
    const without = { ...forced, [id]: runs ? 'off' : 'on' } as const;
    const { [id]: _, ...left } = forced;
    return [id, request({ ...settings, forced: how === 'no' ? without : left })] as const;
  });
  const own: TraceRequests['toggled'] = Object.fromEntries(toggled);
  return {
    main: request(settings),
    other: picture.against && request(otherSide(settings, picture.against)),
    toggled: own,
    // While a picture is built up most is forced off: then pixels are counted when asked for.
    baselines:
      plan.filter(({ forced: how }) => how !== 'no').length > MOST_BASELINES
        ? []
        : plan.flatMap(({ id, forced: how }) => (how === 'no' ? [] : (own[id] ?? []))),
  };
}

/** The effective forcing: 'on' for an effect that is needed anyway gives the same picture. */
function differing(scene: Scene, { forced }: TraceSettings): string {
  const plan = planEffects(scene, forced);
  const order = EFFECTS.map(({ id }) => plan.find((effect) => effect.id === id)?.forced ?? 'no');
  return order.join();
}
