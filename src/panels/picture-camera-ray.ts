import { html, nothing, type TemplateResult } from 'lit';
import { AXES } from '../math/shapes.ts';
import {
  type CameraLine,
  type CameraSteps,
  cameraSteps,
  givenOf,
  givenPiece,
  type PixelRay,
  symbolOf,
  writeLine,
} from '../state/picture/camera-lines.ts';
import { formula } from './formula.ts';
import { MARKS, typeset } from './typeset.ts';
import { value } from './value.ts';
import './picture-camera-ray.css';

const PARTS = [
  { of: 'camera', title: 'The camera, the same for all pixels' },
  { of: 'pixel', title: 'This pixel' },
] as const;

/** How the pixel becomes its ray: each line in symbols, with numbers, with its value, and why. */
export function cameraRay(ray: PixelRay, copy: (as: 'latex' | 'mathml') => void): TemplateResult {
  const steps = cameraSteps(ray);
  return html`<section class="camera-ray" aria-label="From the pixel to its ray">
    ${PARTS.map(
      ({ of, title }) => html`<h3>${title}</h3>
      <p class="camera-given">${givenOf(of, steps).map((id) => given(id, steps))}</p>
      ${steps.lines.filter((line) => line.of === of).map((line) => cameraLine(line, steps))}`,
    )}
    <p class="camera-copy">The ray is E + t d, with E the eye.
      <button type="button" class="textual" @click=${() => copy('latex')}>copy as LaTeX</button>
      <button type="button" class="textual" @click=${() => copy('mathml')}>copy as MathML</button>
    </p>
  </section>`;
}

const given = (id: string, steps: CameraSteps): TemplateResult =>
  html`<span>${formula(
    typeset(`${symbolOf(id, steps.numbers, MARKS)}<mo>=</mo>${givenPiece(id, steps, MARKS)}`),
  )}</span> `;

function cameraLine(line: CameraLine, steps: CameraSteps): TemplateResult {
  const { id, why, values } = line;
  const written = writeLine(line, steps, MARKS);
  const { letter, symbols, numbers, isTriple, isFaithful } = written;
  const sign = isFaithful ? '=' : '≈';
  const parts = numbers?.map((m) => formula(typeset(m))) ?? [];
  return html`<div class="camera-line" data-step=${id}>
    <p>${formula(typeset(`${letter}<mo>=</mo>${symbols}`))}</p>
    <details><summary aria-label=${`why ${id}`}>why</summary>${why}</details>
    ${
      numbers === null
        ? nothing
        : html`<p class="camera-numbers">${sign} ${
            isTriple ? listed(parts) : parts.map((part) => html`${part} `)
          }</p>`
    }
    <p class="camera-value">${numbers === null ? '=' : sign} ${results(id, values)}</p>
  </div>`;
}

/** One number, or (x, y, z). */
function results(id: string, values: readonly number[]): unknown {
  if (values.length === 1) return values.map((x) => value(id, x));
  return listed(values.map((x, k) => value(`${id}.${AXES[k]}`, x)));
}

/** (a, b, c), which may be broken behind a comma. */
const listed = (parts: readonly TemplateResult[]): TemplateResult[] =>
  parts.map(
    (part, k) =>
      html`<span class="camera-part">${k === 0 ? '(' : nothing}${part}${
        k === parts.length - 1 ? ')' : ','
      }</span> `,
  );
