import { html, mathml, type TemplateResult } from 'lit';

/** A formula in MathML, inline or as a block. */
export function formula(content: TemplateResult, display = false): TemplateResult {
  return html`<math class="formula"
    display=${display ? 'block' : 'inline'}><mrow>${content}</mrow></math>`;
}

/** A symbol with an optional subscript; its class gives the colour, its name the highlight. */
export function symbol(
  base: string,
  sub: string | null,
  cls: string,
  lights: string,
): TemplateResult {
  const inner = sub
    ? mathml`<msub class=${cls}
      data-symbol=${lights}><mi>${base}</mi>${
        /\d/.test(sub) ? mathml`<mn>${sub}</mn>` : mathml`<mi>${sub}</mi>`
      }</msub>`
    : mathml`<mi class=${cls} data-symbol=${lights}>${base}</mi>`;
  return formula(inner);
}
