import './clicker.css';

/** What of a key press decides whose it is. */
type Press = Pick<KeyboardEvent, 'key' | 'repeat' | 'altKey' | 'ctrlKey' | 'metaKey' | 'shiftKey'>;

/** What the focus is on: a box for text, a list to choose from, or anything else. */
type Focused = 'text' | 'select' | 'other';

interface ClickerKeys {
  /** The pointer was used: until keys move a control, the page keys are a clicker's. */
  pointer(): void;
  /**
   * Whose the key is: the page's though a control has the focus ('turn'), the black screen's
   * ('back' ends it, 'none' does nothing at all), or that of what has the focus ('control').
   */
  press(event: Press, focused: Focused, isBlack: boolean): 'turn' | 'back' | 'none' | 'control';
  release(key: string): void;
}

const TURNS = ['PageDown', 'PageUp'];
/** Clickers send the one or the other: Kensington's 'b', Logitech's a full stop. */
const BLACK = ['b', '.'];
const BACK = [...BLACK, 'Escape', ...TURNS];

/** The rule for a presenter's clicker, which sends page keys and '.' wherever the focus is. */
export function createClickerKeys(): ClickerKeys {
  let byPointer = false;
  /** The key that ended the black screen, while it is still held. */
  let spent: string | null = null;
  return {
    pointer() {
      byPointer = true;
    },
    press(event, focused, isBlack) {
      const { key, repeat } = event;
      if (repeat && key === spent) return 'none';
      spent = null;
      const plain = !(event.altKey || event.ctrlKey || event.metaKey || event.shiftKey);
      if (isBlack) {
        if (repeat || !plain || !BACK.includes(key)) return 'none';
        spent = key;
        return 'back';
      }
      if (/^(Tab|Arrow|Home|End)/.test(key)) byPointer = false;
      if (!plain || !byPointer) return 'control';
      return TURNS.includes(key) || (BLACK.includes(key) && focused === 'select')
        ? 'turn'
        : 'control';
    },
    release(key) {
      if (key === spent) spent = null;
    },
  };
}

/**
 * Lets a clicker turn pages after a click on a control, where `turns` says that there is something
 * to turn. Returns what makes the whole page black; `announce` is told when it is seen again.
 */
export function watchClicker(turns: () => boolean, announce: (words: string) => void): () => void {
  const screen = blackScreen(announce);
  const keys = createClickerKeys();
  const down = (event: KeyboardEvent): void => {
    // Some clickers begin a show with F5: on a stage that would take back what is revealed.
    if (event.key === 'F5' && document.fullscreenElement) {
      event.preventDefault();
      event.stopImmediatePropagation();
      return;
    }
    const at = event.target instanceof HTMLElement ? event.target : null;
    const focused = at?.matches('select') ? 'select' : at?.matches(TEXT) ? 'text' : 'other';
    const whose = keys.press(event, focused, screen.open);
    if (whose === 'control') return;
    if (whose === 'turn') {
      const on = event.target as Element;
      if (!on.closest(CONTROLS) || on.closest('dialog')) return;
      if (!BLACK.includes(event.key) && !turns()) return;
      event.preventDefault();
      event.stopPropagation();
      // What was typed counts, as when the box is left by any other way.
      if (focused === 'text') at?.blur();
      document.body.dispatchEvent(new KeyboardEvent(event.type, event));
      return;
    }
    event.stopImmediatePropagation();
    if (whose === 'none' && !event.repeat) return;
    event.preventDefault();
    if (whose === 'back') screen.close();
  };
  window.addEventListener('pointerdown', keys.pointer, true);
  window.addEventListener('keydown', down, true);
  window.addEventListener('keyup', ({ key }) => keys.release(key), true);
  return () => {
    if (screen.open) return;
    document.body.append(screen);
    screen.showModal();
  };
}

const TEXT = 'input:not([type=range], [type=checkbox], [type=radio])';
const CONTROLS = 'input, select, [role=slider], [role=application], .scene';

/**
 * A modal dialog, so that nothing below it is reached; the focus returns to where it was. In the
 * document only while it is open.
 */
function blackScreen(announce: (words: string) => void): HTMLDialogElement {
  const screen = document.createElement('dialog');
  screen.className = 'black-screen';
  screen.setAttribute('aria-label', 'Black screen');
  const button = document.createElement('button');
  button.type = 'button';
  button.setAttribute('aria-label', 'Show the page again');
  screen.append(button);
  screen.addEventListener('click', (event) => {
    event.stopPropagation();
    screen.close();
  });
  screen.addEventListener('wheel', (event) => event.preventDefault(), { passive: false });
  screen.addEventListener('close', () => {
    // The event comes a task later: a quick press may have opened it again.
    if (screen.open) return;
    screen.remove();
    announce('The page is shown again.');
  });
  return screen;
}
