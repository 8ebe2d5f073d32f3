import { describe, expect, test } from 'vitest';
import { createClickerKeys } from '../../../src/ui/clicker.ts';

const NONE = { repeat: false, altKey: false, ctrlKey: false, metaKey: false, shiftKey: false };
const press = (key: string, more: Partial<typeof NONE> = {}) => ({ ...NONE, key, ...more });

describe('with a control in focus', () => {
  test.each(['PageDown', 'PageUp'])('%s turns pages only after the pointer', (key) => {
    const keys = createClickerKeys();
    expect(keys.press(press(key), 'other', false)).toBe('control');
    keys.pointer();
    expect(keys.press(press(key), 'text', false)).toBe('turn');
    expect(keys.press(press(key, { shiftKey: true }), 'other', false)).toBe('control');
    expect(keys.press(press(key), 'other', false)).toBe('turn');
  });

  test.each(['Tab', 'ArrowLeft', 'Home', 'End'])('after %s the control has them again', (key) => {
    const keys = createClickerKeys();
    keys.pointer();
    expect(keys.press(press(key), 'other', false)).toBe('control');
    expect(keys.press(press('PageDown'), 'other', false)).toBe('control');
    keys.pointer();
    expect(keys.press(press('PageDown'), 'other', false)).toBe('turn');
  });

  test.each(['.', 'b'])('%s is text in a box, and a key of the page on a list', (key) => {
    const keys = createClickerKeys();
    keys.pointer();
    expect(keys.press(press(key), 'text', false)).toBe('control');
    expect(keys.press(press(key), 'select', false)).toBe('turn');
  });

  test('digits and letters are the control’s', () => {
    const keys = createClickerKeys();
    keys.pointer();
    for (const key of ['1', 'b', 'Enter', ' ']) {
      expect(keys.press(press(key), 'text', false)).toBe('control');
    }
    expect(keys.press(press('PageDown'), 'text', false)).toBe('turn');
  });
});

describe('while the screen is black', () => {
  test.each(['.', 'b', 'Escape', 'PageDown', 'PageUp'])(
    '%s ends it, once however long held',
    (key) => {
      const keys = createClickerKeys();
      expect(keys.press(press(key), 'other', true)).toBe('back');
      expect(keys.press(press(key, { repeat: true }), 'other', false)).toBe('none');
      keys.release(key);
      expect(keys.press(press(key), 'other', false)).toBe('control');
    },
  );

  test('no other key does anything, nor the one still held that began it', () => {
    const keys = createClickerKeys();
    expect(keys.press(press('.', { repeat: true }), 'other', true)).toBe('none');
    for (const key of ['t', '3', 'ArrowRight', 'Enter']) {
      expect(keys.press(press(key), 'other', true)).toBe('none');
    }
    expect(keys.press(press('PageDown', { ctrlKey: true }), 'other', true)).toBe('none');
  });
});
