import { html, type TemplateResult } from 'lit';
import { LESSON_IDS, lessonOf } from '../../lesson/lessons/index.ts';

interface ListTools {
  readonly hasOwn: boolean;
  readonly goOn: () => void;
  /** Adds what Explore shows to the own lesson as its next step. */
  readonly collect: () => void;
  readonly openFile: () => void;
}

/** The list of lessons, and buttons for the own lesson. */
export function listView({ hasOwn, goOn, collect, openFile }: ListTools): TemplateResult {
  return html`<section class="lesson-list" aria-label="Lessons">
    <h2>Lessons</h2>
    <ol>
      ${LESSON_IDS.map((id) => {
        const found = lessonOf(id);
        if (!found) return html``;
        const { title, about, steps } = found.lesson;
        return html`<li>
          <a href=${`#/lesson/${id}`}>${title}</a> <span class="count">${steps.length} steps</span>
          <p>${about}</p>
        </li>`;
      })}
    </ol>
    <h2>Your own</h2>
    <p>A lesson is a text with a link of Graze for each step. It is written here, or
      in any editor; the address carries it.</p>
    <p class="own-buttons">
      <button type="button" class="bordered"
        @click=${collect}>${hasOwn ? 'Add' : 'Start from'} what Explore shows</button>
      ${
        hasOwn
          ? html`<button type="button" class="bordered"
        @click=${goOn}>Go on with yours</button>`
          : ''
      }
      <button type="button" class="bordered" @click=${openFile}>Open a file</button>
    </p>
  </section>`;
}
