import { html, type TemplateResult } from 'lit';
import './picture-play.css';

interface PlayModel {
  /** How many rays are there, of how many; null while all are and none is picked. */
  readonly at: number | null;
  readonly count: number;
  readonly runs: boolean;
  /** What the ray is, and what became of it; '' for none. */
  readonly words: string;
}

interface PlayTools {
  toggle(): void;
  step(by: 1 | -1): void;
}

const ICONS = {
  back: 'M2 2H3.500V10H2ZM10 2V10L4.500 6Z',
  play: 'M2.500 1.500L10 6L2.500 10.500Z',
  pause: 'M2 1.500H5V10.500H2ZM7 1.500H10V10.500H7Z',
  on: 'M8.500 2H10V10H8.500ZM2 2L7.500 6L2 10Z',
};

/** Below the rays in space: plays them one after another, and says what each is. */
export function playBar({ at, count, runs, words }: PlayModel, tools: PlayTools): TemplateResult {
  const button = (label: string, icon: keyof typeof ICONS, press: () => void): TemplateResult =>
    html`<button type="button" class="play-step" aria-label=${label} title=${label}
      @click=${press}><svg viewBox="0 0 12 12" width="12" height="12" aria-hidden="true"><path
      d=${ICONS[icon]} /></svg></button>`;
  return html`<div class="play-bar"><div class="play-buttons" role="group"
      aria-label="rays one after another">${button('ray before', 'back', () => tools.step(-1))}${
        runs
          ? button('stand still', 'pause', tools.toggle)
          : button('play the rays', 'play', tools.toggle)
      }${button('next ray', 'on', () => tools.step(1))}</div><p class="play-words"
      data-quantity="ray" data-value=${at ?? count}>${
        at === null ? html`${count} ${count === 1 ? 'ray' : 'rays'}` : html`${at} of ${count}`
      }${words ? html` <span>${words}</span>` : ''}</p></div>`;
}
