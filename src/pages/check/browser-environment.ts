import type { Environment } from '../../state/course/course.ts';

const two = (x: number): string => String(x).padStart(2, '0');

/** Clocks and random ids of the browser. */
export const BROWSER_ENVIRONMENT: Environment = {
  now: () => performance.now(),
  clock() {
    const now = new Date();
    return [now.getHours(), now.getMinutes(), now.getSeconds()].map(two).join(':');
  },
  // Hundredths of a second: SCORM allows no more digits.
  stamp: () => `${new Date().toISOString().slice(0, 22)}Z`,
  uuid() {
    // crypto.randomUUID exists only in secure contexts: HTTPS and localhost.
    const bytes = crypto.getRandomValues(new Uint8Array(16));
    const hex = Array.from(bytes, (byte, i) => {
      const own = i === 6 ? (byte & 0x0f) | 0x40 : i === 8 ? (byte & 0x3f) | 0x80 : byte;
      return own.toString(16).padStart(2, '0');
    }).join('');
    return hex.replace(/^(.{8})(.{4})(.{4})(.{4})(.{12})$/, '$1-$2-$3-$4-$5');
  },
};
