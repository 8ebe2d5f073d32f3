import { expect, test } from 'vitest';
import { type Grip, watchDrags } from '../../../src/ui/drags.ts';

/** What was told of presses at these places, in order: each "type id x y". */
function told(pointerType: string, ...events: readonly string[]): readonly string[] {
  const words: string[] = [];
  const element = Object.assign(new EventTarget(), { setPointerCapture: () => {} });
  const at = ({ x, y, spread }: Grip): string => `${x},${y} ${spread}`;
  watchDrags(element as never, {
    takes: () => true,
    drags: () => words.push('drag'),
    move: (now, from) => words.push(`${at(from)} to ${at(now)}`),
    end: (isCancelled) => words.push(isCancelled ? 'cancelled' : 'end'),
  });
  for (const event of events) {
    const [type, id, x, y] = event.split(' ');
    const fields = { pointerId: Number(id), pointerType, clientX: Number(x), clientY: Number(y) };
    element.dispatchEvent(Object.assign(new Event(`pointer${type}`), fields));
  }
  return words;
}

test('a press is a drag from three pixels on, and a click before', () => {
  expect(told('mouse', 'down 1 0 0', 'move 1 2 0', 'up 1 2 0')).toEqual([]);
  expect(told('mouse', 'down 1 0 0', 'move 1 3 0', 'up 1 3 0')).toEqual([
    'drag',
    '0,0 0 to 3,0 0',
    'end',
  ]);
});

test('a finger that goes up or down first scrolls, whatever it does then', () => {
  const scroll = ['down 1 0 0', 'move 1 0 10', 'move 1 50 10', 'up 1 50 10'];
  expect(told('touch', ...scroll)).toEqual([]);
});

test('two fingers pinch at once; the one that stays begins anew', () => {
  const pinch = [
    'down 1 0 0',
    'down 2 10 0',
    'move 2 20 0',
    'up 1 0 0',
    'move 2 25 0',
    'up 2 25 0',
  ];
  expect(told('touch', ...pinch)).toEqual(['drag', '5,0 10 to 10,0 20', '20,0 0 to 25,0 0', 'end']);
});

test('what the browser takes for its own scroll is cancelled', () => {
  expect(told('touch', 'down 1 0 0', 'move 1 10 0', 'cancel 1 10 0')).toEqual([
    'drag',
    '0,0 0 to 10,0 0',
    'cancelled',
  ]);
});
