import { html, mathml, nothing, type TemplateResult } from 'lit';
import { comp, type Expr, type ExprTriple, walkLength, withScalars } from '../math/formula.ts';
import type { Hit } from '../math/index.ts';
import { AXES, definitionOf } from '../math/shapes.ts';
import type { Dispatch } from '../state/actions.ts';
import type { ExploreModel } from '../state/derive.ts';
import { putInSideBySide } from '../state/put-in.ts';
import { displayTriple } from '../text/format.ts';
import { subscript } from '../text/scripts.ts';
import { formula, symbol } from './formula.ts';
import { typesetNumbers, typesetSymbols } from './typeset.ts';

/** Digits of a number put in, where the faithful ones are more than the line has room for. */
const SHORT = 4;
const MOST = 6;

/** A component of N: half the gradient in x, y, z; of a flat shape its own N. */
const treesOf = ({ shape }: ExploreModel): ExprTriple => {
  const own = definitionOf(shape).formula(shape);
  if (own.family === 'curved') return own.normal;
  return AXES.map((axis) => comp('N', axis)) as unknown as ExprTriple;
};

/**
 * The line of N on the card: in symbols, with the numbers of the first hit put in, and its value.
 * `why` is the step of the walk that says where it comes from.
 */
export function normalLine(model: ExploreModel, dispatch: Dispatch): TemplateResult {
  const trees = treesOf(model);
  const { found, shown, hits, shape } = model;
  const at = Math.max(
    0,
    hits.findIndex(({ role }) => role === 'first'),
  );
  const hit = shown.hits ? found.hits[at] : undefined;
  const isCurved = found.details.family === 'curved';
  const why = isCurved
    ? html`<button type="button" class="why" aria-label="why N"
        @click=${() => dispatch({ type: 'derive', step: walkLength(shape) })}>why</button>`
    : nothing;
  return html`<div class="step stacked normal-line" data-step="N">
    <span class="letter">${symbol('N', null, 'sym sym-normal', 'N')}${why}</span>
    <span class="equals">=</span>
    <span class="body">
      <span class="in-symbols">${triple(trees, typesetSymbols)}</span>
      ${
        shown.hits
          ? hit && isCurved
            ? numbers(trees, hit, at, model)
            : nothing
          : html`<span
        class="in-numbers">?</span>`
      }
    </span>
    ${
      hit
        ? html`<span class="normal-value">N${subscript(at + 1)} = ${valueAt(hit)}</span>`
        : nothing
    }
  </div>`;
}

const valueAt = ({ normal, singular }: Hit): string => (singular ? 'zero' : displayTriple(normal));

function triple(trees: ExprTriple, write: (expr: Expr) => TemplateResult): TemplateResult {
  const comma = mathml`<mo separator="true">,</mo>`;
  const parts = trees.map((tree, i) => mathml`${i > 0 ? comma : nothing}${write(tree)}`);
  return formula(mathml`<mo stretchy="false">(</mo>${parts}<mo stretchy="false">)</mo>`);
}

/** With ≈ where the line as it is printed does not give the value in all its digits. */
function numbers(
  trees: ExprTriple,
  { point: [x, y, z], normal }: Hit,
  at: number,
  { derivation }: ExploreModel,
): TemplateResult | typeof nothing {
  const there = withScalars(derivation.numbers, { x, y, z });
  const lines = trees.map((expr, i) => ({
    expr,
    results: [{ value: normal[i] ?? 0, text: null, branch: 1 as const }],
  }));
  const written = putInSideBySide(lines, there, false, MOST);
  if (!written) return nothing;
  const { isFaithful } = written;
  const digits = isFaithful ? written.digits : SHORT;
  const put = triple(trees, (expr) => typesetNumbers(expr, there, { worked: false, digits }));
  const sign = isFaithful ? '' : '≈ ';
  return html`<span class="in-numbers">${sign}${put} at P${subscript(at + 1)}</span>`;
}
