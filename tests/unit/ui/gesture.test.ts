import { expect, test } from 'vitest';
import { watchGestures } from '../../../src/ui/gesture.ts';

const tasksDone = () => new Promise((done) => setTimeout(done));

test('a press that comes before the last release has settled is a gesture to its end', async () => {
  const page = new EventTarget();
  const gesture = watchGestures(page, page);
  const send = (type: string) => page.dispatchEvent(new Event(type));
  expect(gesture()).toBeNull();
  send('pointerdown');
  const first = gesture();
  send('pointerup');
  // The click that follows at once is still part of it.
  expect(gesture()).toBe(first);
  send('pointerdown');
  const second = gesture();
  expect(second).not.toBe(first);
  await tasksDone();
  expect(gesture()).toBe(second);
  send('pointercancel');
  await tasksDone();
  expect(gesture()).toBeNull();
});

test('turns of the wheel are one gesture, and so are two fingers', async () => {
  const page = new EventTarget();
  const gesture = watchGestures(page, page);
  const send = (type: string, more = {}) =>
    page.dispatchEvent(Object.assign(new Event(type), more));
  send('wheel');
  const turned = gesture();
  send('wheel');
  expect(turned).not.toBeNull();
  expect(gesture()).toBe(turned);
  send('pointerdown', { isPrimary: true });
  const pressed = gesture();
  expect(pressed).not.toBe(turned);
  send('pointerdown', { isPrimary: false });
  expect(gesture()).toBe(pressed);
  send('pointerup');
  await tasksDone();
  expect(gesture()).toBeNull();
});
