import { html, type TemplateResult } from 'lit';

interface EditTools {
  /** The text as it is being written. */
  readonly text: string;
  readonly title: string;
  readonly change: (text: string) => void;
  readonly changeTitle: (title: string) => void;
  readonly done: () => void;
  readonly cancel: () => void;
  readonly remove: () => void;
  readonly earlier: () => void;
  readonly later: () => void;
  readonly isFirst: boolean;
  readonly isLast: boolean;
}

/** The form for a step's text, shown in place of the text. */
export function editView(tools: EditTools): TemplateResult {
  const { text, title, change, changeTitle, done, cancel, remove } = tools;
  const written = (event: Event): string =>
    (event.target as HTMLInputElement | HTMLTextAreaElement).value;
  return html`<form class="lesson-edit" aria-label="Edit this step" @submit=${(event: Event) => {
    event.preventDefault();
    done();
  }}>
    <label>Title of the lesson
      <input .value=${title} @input=${(event: Event) => changeTitle(written(event))} /></label>
    <label>This step
      <textarea rows="16" spellcheck="true" .value=${text}
        @input=${(event: Event) => change(written(event))}></textarea></label>
    <p class="hint">{t1} is the value that is shown, \`r\` a symbol,
      {slider} the slider of <code>free: r</code>.</p>
    <p class="edit-buttons">
      <button type="submit" class="primary">Done</button>
      <button type="button" class="bordered" @click=${cancel}>Cancel</button>
      <button type="button" class="bordered"
        aria-disabled=${tools.isFirst}
        @click=${tools.earlier}>Earlier</button>
      <button type="button" class="bordered"
        aria-disabled=${tools.isLast}
        @click=${tools.later}>Later</button>
      <button type="button" class="bordered"
        aria-disabled=${tools.isFirst && tools.isLast}
        @click=${remove}>Remove</button>
    </p>
  </form>`;
}
