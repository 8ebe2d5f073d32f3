import { html, nothing, render } from 'lit';
import type { Intersection, Shape } from '../../math/index.ts';
import type { ShapeKind } from '../../math/shapes.ts';
import type { ExploreModel } from '../../state/derive.ts';
import { display } from '../../text/format.ts';
import type { Announce } from '../../ui/announcer.ts';
import { recall, remember } from '../../ui/storage.ts';

/** Something to achieve with the sliders, and what the page says when it is achieved. */
interface Challenge {
  readonly id: string;
  /** The shape it is about; null for every curved one. */
  readonly kind: ShapeKind | null;
  readonly asks: string;
  /** Words on what is achieved; null if it is not. */
  met(model: Pick<ExploreModel, 'found' | 'ended' | 'shape' | 'near'>): string | null;
}

export const CHALLENGES: readonly Challenge[] = [
  {
    id: 'tangent',
    kind: null,
    asks: 'make it tangent',
    met({ found, near }) {
      if (found.class === 'tangent') return 'tangent: D = 0';
      // A drag snaps to the doubles next to tangency, where none are on it.
      return near ? 'tangent as nearly as doubles can' : null;
    },
  },
  {
    id: 'upper',
    kind: 'cone',
    asks: 'hit only the upper nappe',
    met({ found, ended, shape }) {
      const hits = found.hits.filter((_, i) => !ended?.cut[i]);
      const [, height] = (shape as { vertex?: readonly number[] }).vertex ?? [];
      const upper = height !== undefined && hits.every(({ point }) => point[1] > height);
      return upper && hits.some(({ t }) => t >= 0) ? 'all points are above V' : null;
    },
  },
  {
    id: 'behind',
    kind: null,
    asks: 'make t₁ negative',
    met({ found: { hits } }) {
      const [first] = hits;
      return first && first.t < 0 ? `t₁ = ${display(first.t)}` : null;
    },
  },
];

const STORED = 'graze.challenges';
/** Stored instead of an id if no challenge is to be shown again. */
const NO_MORE = 'no-more';

/**
 * One line over the scene, from the first change on: the next challenge, and the one that was just
 * met. Challenges that were met are stored on the device and not shown again. During a drag none is
 * met; at its end `changed` asks for a drawing, which checks them.
 */
export function createChallenges(
  changed: () => void,
  announce: Announce,
): (host: HTMLElement, model: ExploreModel) => null {
  // The first change, which loads this code, may be part of a drag.
  let isDragging = true;
  const press = (): void => {
    isDragging = true;
  };
  const release = (): void => {
    isDragging = false;
    changed();
  };
  window.addEventListener('pointerdown', press, { capture: true, passive: true });
  for (const end of ['pointerup', 'pointercancel', 'keyup'])
    window.addEventListener(end, release, { capture: true, passive: true });
  const done = new Set((recall(STORED) ?? '').split(' ').filter(Boolean));
  /** Words on the challenge that was met last. */
  let praise = '';
  let praised: Intersection | null = null;
  const keep = (id: string): void => {
    done.add(id);
    remember(STORED, [...done].join(' '));
  };
  const open = ({ kind }: Shape): readonly Challenge[] =>
    CHALLENGES.filter((one) => !done.has(one.id) && (one.kind ?? kind) === kind);
  return (host, model) => {
    const { found, shape, state } = model;
    const curved = found.details.family === 'curved';
    const on = curved && state.revealed === null && !done.has(NO_MORE);
    for (const { id, asks, met } of on && !model.passing && !isDragging ? open(shape) : []) {
      const now = met(model);
      if (now === null) continue;
      keep(id);
      praise = `Done: ${asks} (${now}). `;
      announce(praise.trim(), 'challenge');
      praised = found;
    }
    const [next] = open(shape);
    const shown = on && (next || found === praised);
    const end = (): void => {
      keep(NO_MORE);
      render(nothing, host);
    };
    render(
      shown
        ? html`<p class="challenge"><span>${praise}${next ? `Try: ${next.asks}.` : ''}</span>
            <button type="button" class="challenge-end" aria-label="No more challenges"
              title="No more challenges" @click=${end}>×</button>
          </p>`
        : nothing,
      host,
    );
    return null;
  };
}
