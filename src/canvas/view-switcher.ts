import type { Dispatch } from '../state/actions.ts';
import { NAMED_VIEWS, type View } from '../state/camera-view.ts';

/** The view switcher: one real button for each named view. */
export function viewSwitcher(parent: Element, dispatch: Dispatch): (view: View) => void {
  const group = document.createElement('div');
  group.className = 'scene-views';
  group.setAttribute('role', 'group');
  group.setAttribute('aria-label', 'view');
  const buttons = NAMED_VIEWS.map(({ id, title }) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = title;
    button.addEventListener('click', () => dispatch({ type: 'view', view: id }));
    group.append(button);
    return { id, button };
  });
  parent.append(group);
  let shown: View | null = null;
  return (view) => {
    if (view === shown) return;
    shown = view;
    for (const { id, button } of buttons) button.setAttribute('aria-pressed', String(id === view));
  };
}
