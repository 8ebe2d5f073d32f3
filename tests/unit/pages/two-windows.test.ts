import fc from 'fast-check';
import { expect, test } from 'vitest';
import {
  CLICKER_KEYS,
  type Message,
  openChannel,
  type Projected,
  presenterIn,
  readMessage,
} from '../../../src/pages/lesson/presenter-channel.ts';

const LOOK = { revealed: 2, told: false, example: 'cone-tangent' };
const NUMBERS = { 'textbook.t1': { value: 3.75, text: '3.75000' } };
const STEP: Projected = { hash: '#/lesson/digits?step=3', numbers: NUMBERS, look: null };

const MESSAGES: readonly Message[] = [
  { type: 'hello' },
  { type: 'shown', stage: null },
  { type: 'shown', stage: STEP },
  { type: 'shown', stage: { hash: '#/explore?shape=cone', numbers: {}, look: LOOK } },
  ...CLICKER_KEYS.map((key): Message => ({ type: 'key', key })),
];

test('a message is read as it was sent, and nothing that comes with it', () => {
  for (const message of MESSAGES) expect(readMessage({ ...message, more: 1 })).toEqual(message);
});

test('what is no message is ignored, whatever it is', () => {
  for (const data of [
    { type: 'key', key: 'F5' },
    { type: 'key', key: 'toString' },
    { type: 'shown' },
    { type: 'shown', stage: '#/lesson/ray' },
    ...[
      { hash: 'javascript:alert(1)' },
      { hash: '#/check', look: LOOK },
      { hash: '#/explore' },
      { hash: `#/lesson/${'x'.repeat(1_000_000)}` },
      { look: LOOK },
      { numbers: [1] },
      { numbers: { t1: { value: null, text: '3' } } },
      { numbers: { t1: { value: 3, text: 'x'.repeat(201) } } },
      { numbers: Object.fromEntries(Array.from({ length: 501 }, (_, i) => [i, NUMBERS])) },
      { hash: '#/explore', look: { ...LOOK, revealed: -1 } },
      { hash: '#/explore', look: { ...LOOK, told: 'yes' } },
    ].map((fault) => ({ type: 'shown', stage: { ...STEP, ...fault } })),
  ]) {
    expect(readMessage(data)).toBeNull();
  }
  fc.assert(
    fc.property(fc.anything(), (data) => {
      const read = readMessage(data);
      if (read !== null) expect(data).toMatchObject(read);
    }),
  );
});

test('only an address with an id is that of a presenter’s window', () => {
  expect(presenterIn('?presenter=a1b2')).toBe('a1b2');
  for (const search of ['', '?presenter', '?presenter=', '?presenter=A b', '?x=a1']) {
    expect(presenterIn(search)).toBeNull();
  }
});

test('windows of one id hear each other, and no other ones', async () => {
  const heard: Message[] = [];
  const foreign: Message[] = [];
  const done = new Promise<void>((resolve) => {
    openChannel('one', (message) => {
      heard.push(message);
      if (message.type === 'hello') resolve();
    });
  });
  openChannel('two', (message) => foreign.push(message));
  new BroadcastChannel('graze.presenter.one').postMessage('noise');
  const sender = openChannel('one', () => {});
  for (const message of [...MESSAGES].reverse()) sender.send(message);
  await done;
  expect(heard).toEqual([...MESSAGES].reverse());
  expect(foreign).toEqual([]);
});
