import { test as base, expect } from '@playwright/test';
import { countPending } from './pending.ts';

export { expect };

/** The software GL driver's remark on its own speed when a test takes a screenshot. */
const DRIVER_REMARK =
  /^\[\.WebGL-0x[0-9a-f]+\] ?GL Driver Message \(OpenGL, Performance, \w+, High\): GPU stall/;

/**
 * Software rendering takes most of a test's time. Where nobody looks at the pixels, the scene does
 * all but fill triangles: it is loaded, lays out, counts its frames and moves its handles.
 */
function withoutInk(): void {
  const { prototype } = WebGL2RenderingContext;
  for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced'])
    Object.defineProperty(prototype, name, { value: () => undefined });
}

interface Strict {
  /** Whether the canvas of the scene is filled. */
  ink: boolean;
  /** What a test provokes on purpose and may therefore appear on the console. */
  provoked: RegExp | null;
  /** Everything that went wrong so far; a test may look at it before its end. */
  complaints: string[];
}

/**
 * Every test fails on an error or warning on the console, an uncaught error, a dialog, and on any
 * request that leaves the page's own origin.
 */
export const test = base.extend<Strict>({
  provoked: [null, { option: true }],
  ink: [false, { option: true }],
  complaints: [
    async ({ context, baseURL, provoked, ink }, use) => {
      await context.addInitScript(countPending);
      if (!ink) await context.addInitScript(withoutInk);
      const complaints: string[] = [];
      const complain = (text: string): void => {
        if (!DRIVER_REMARK.test(text) && !provoked?.test(text)) complaints.push(text);
      };
      context.on('console', (message) => {
        if (message.type() === 'error' || message.type() === 'warning') complain(message.text());
      });
      context.on('weberror', (error) => complain(String(error.error())));
      context.on('dialog', (dialog) => {
        complain(`dialog: ${dialog.message()}`);
        void dialog.dismiss();
      });
      context.on('request', (request) => {
        const own = [baseURL ?? '', 'data:', 'blob:', 'file:'];
        if (!own.some((start) => request.url().startsWith(start))) {
          complain(`request to ${request.url().slice(0, 200)}`);
        }
      });
      await use(complaints);
      expect(complaints, 'the console, errors, dialogs and foreign requests').toEqual([]);
    },
    { auto: true },
  ],
});
