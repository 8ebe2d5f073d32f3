import { test as base, expect } from '@playwright/test';

export { expect };

/** The software GL driver's remark on its own speed when a test takes a screenshot. */
const DRIVER_REMARK =
  /^\[\.WebGL-0x[0-9a-f]+\] ?GL Driver Message \(OpenGL, Performance, GL_CLOSE_PATH_NV, High\): GPU stall due to ReadPixels/;

interface Strict {
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
  complaints: [
    async ({ context, baseURL, provoked }, use) => {
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
