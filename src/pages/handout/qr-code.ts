import { html, svg, type TemplateResult } from 'lit';
import { encode } from 'uqr';

export const QR_CODE = {
  /** Of the printed code with its margin, as in handout.css: phones read modules of 0.3 mm. */
  millimetres: 28,
  /** UTF-8 bytes that the largest version holds, with the least correction. */
  mostBytes: 586,
  options: { ecc: 'L', boostEcc: true, maxVersion: 16, border: 4 },
} as const;

/** The link as a QR code's rows, true where it is dark; or a sentence on why there is none. */
export function qrRows(link: string, what = 'link'): readonly (readonly boolean[])[] | string {
  if (link.startsWith('file:')) {
    return 'No QR code: this page was opened from a file, which no other device has.';
  }
  const bytes = new TextEncoder().encode(link).length;
  if (bytes > QR_CODE.mostBytes) {
    const most = `one that phones read from paper holds ${QR_CODE.mostBytes}`;
    return `No QR code: this ${what} has ${bytes} bytes, and ${most}.`;
  }
  return encode(link, QR_CODE.options).data;
}

/**
 * The link as a picture of its code, or words.
 *
 * @param link the whole address, or another text
 * @param what it is, in words
 */
export function qrCode(link: string, what = 'link'): TemplateResult {
  const rows = qrRows(link, what);
  if (typeof rows === 'string') return html`<p class="no-code">${rows}</p>`;
  const path = rows
    .flatMap((row, y) => row.map((dark, x) => (dark ? `M${x} ${y}h1v1h-1z` : '')))
    .join('');
  const name = `QR code of the ${what}`;
  return html`<svg class="link-code" viewBox="0 0 ${rows.length} ${rows.length}" role="img"
    aria-label=${name} shape-rendering="crispEdges">${svg`<path d=${path} />`}</svg>`;
}
