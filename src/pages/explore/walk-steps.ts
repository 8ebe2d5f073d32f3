import { html, mathml, nothing, type TemplateResult } from 'lit';
import { plainText } from '../../lab/plain-text.ts';
import {
  type Derivation,
  type Expr,
  evaluate,
  float64,
  inSymbols,
  LATEX,
  num,
  scalar,
  squared,
  type Term,
  times,
  type Values,
  type WalkColumn,
  type WalkLine,
  type WalkPart,
  type WalkStep,
  walkSide,
  withScalars,
} from '../../math/formula.ts';
import type { Hit } from '../../math/index.ts';
import { conditions } from '../../panels/algebra.ts';
import { formula } from '../../panels/formula.ts';
import { typesetNumbers, typesetNumbersInPieces, typesetSymbols } from '../../panels/typeset.ts';
import { value } from '../../panels/value.ts';
import { type ExploreModel, isFull } from '../../state/derive.ts';
import { putInSideBySide, resultsOf } from '../../state/put-in.ts';
import { hitOfNormal, type NormalChoice } from '../../state/walk-figures.ts';
import { normalFigure } from '../../state/walk-normal.ts';
import {
  closestWords,
  facingWords,
  nudgeWords,
  type SignedLine,
  signWords,
} from '../../state/walk-words.ts';
import { displayTriple } from '../../text/format.ts';
import { subscript } from '../../text/scripts.ts';

export type Step = WalkStep;

/** Most digits of a number in a line without a result. */
const MOST = 15;

/** In the step about N: words on the figure in the scene, and buttons for further normals. */
function normalChoice(
  { id }: Step,
  model: ExploreModel,
  { choice, choose }: NormalsShown,
): TemplateResult | typeof nothing {
  const about = model.shown.hits && (id === 'normal' || id === 't') ? hitOfNormal(model) : null;
  if (!about || !isFull(model)) return nothing;
  const { hit, index } = about;
  const figure = normalFigure(model.shape, hit, model.scene.stage);
  const toggle = (key: keyof NormalChoice, words: string): TemplateResult =>
    html`<button type="button" class="walk-choice" aria-pressed=${choice[key]}
      @click=${() => choose({ ...choice, [key]: !choice[key] })}>${words}</button>`;
  return html`<div class="walk-normals">
    ${
      figure
        ? html`<p class="walk-results walk-sign">P${subscript(index + 1)}: ${nudgeWords(
            model.shape,
            hit,
            figure,
          )}.</p>`
        : nothing
    }
    <p class="walk-choices" role="group" aria-label="Normals shown beside the course's">
      Show beside N: ${toggle('unit', 'n = N/|N|')} ${toggle('facing', '−N where N·d > 0')}
    </p>
  </div>`;
}

/** Which normals are shown beside the course's, and a function to change that. */
export interface NormalsShown {
  readonly choice: NormalChoice;
  choose(choice: NormalChoice): void;
}

/** One step, number `n`; the present one with all its layers. */
export function stepOf(
  step: Step,
  n: number,
  isPresent: boolean,
  model: ExploreModel,
  normals: NormalsShown | null = null,
): TemplateResult {
  return html`<li class=${isPresent ? 'walk-step present' : 'walk-step'} data-derivation-step=${n}
    data-step=${step.id}>
    <div class="walk-name"><span class="walk-number">${n}</span> ${step.name}
      ${isPresent ? html`<p class="walk-why">${step.why}</p>` : nothing}</div>
    <div class="walk-lines">${isPresent ? present(step, model) : short(step)}
      ${isPresent && normals ? normalChoice(step, model, normals) : nothing}</div>
  </li>`;
}

/** The line that threads lead to and from stands in one row, where it can. */
const lineClass = ({ id }: Step): string => (id === 'expand' ? 'walk-line walk-fits' : 'walk-line');

function short(step: Step): TemplateResult {
  const { lines, columns } = step;
  if (columns && lines[0]) {
    return html`<div class="walk-line" data-tex=${texOf(lines[0])}>${powers(columns)}</div>`;
  }
  return html`${lines.map(
    (line) => html`<div class=${lineClass(step)} data-tex=${texOf(line)}>
      <div class="walk-symbols">${sides(line)}</div></div>`,
  )}`;
}

function present(step: Step, model: ExploreModel): TemplateResult {
  const { id, lines, columns } = step;
  const shown = model.shown.hits;
  if (columns && lines[0]) return bill(lines[0], columns, model);
  const said = shown ? signWords(model.shape, model.ray) : {};
  return html`${lines.map((line) => {
    const letter = walkSide(line.left);
    const words = letter.op === 'scalar' ? said[letter.id as SignedLine] : undefined;
    return html`<div class=${lineClass(step)} data-tex=${texOf(line)}>
      <div class="walk-symbols">${sides(line, true)}</div>
      ${shown && id !== 'figure' ? numbersOf(step, line, model) : nothing}
      ${words && id !== 'roots' ? sentence(words) : nothing}
    </div>`;
  })}
  ${shown ? results(step, model, said) : nothing}`;
}

const sentence = (words: string): TemplateResult =>
  html`<p class="walk-results walk-sign">${words}.</p>`;

function texOf({ left, relation, right }: WalkLine): string {
  const [these, those] = [left, right].map((parts) => inSymbols(walkSide(parts), LATEX));
  return `${these} ${relation === '≤' ? '\\le' : '='} ${those}`;
}

/* The symbols of a line, term by term, so that it can be broken between them. */

const isNothing = formula(mathml`<mo>=</mo><mn>0</mn>`);

function sides({ left, relation, right }: WalkLine, isPresent = false): TemplateResult {
  const sign = formula(mathml`<mo>${relation}</mo>`);
  if (right.length === 0) return terms(left, isPresent, isNothing);
  return html`${terms(left, isPresent, sign)} ${terms(right, isPresent)}`;
}

/** Terms between which a line may break; `behind` stays with the last one. */
function terms(
  parts: readonly WalkPart[],
  isPresent: boolean,
  behind: TemplateResult | typeof nothing = nothing,
): TemplateResult {
  const all = parts.length > 0 ? parts : [{ sign: 1, expr: num(0), products: [] } as const];
  return html`${all.map((part, i) => {
    const m = term(part, i > 0, isPresent);
    return i === all.length - 1 ? html`<span class="walk-last">${m} ${behind}</span>` : html`${m} `;
  })}`;
}

/** A term with its sign; `data-terms` are the numbers of its products. */
function term({ sign, expr, products }: WalkPart, isInside: boolean, isPresent: boolean) {
  const mark = isInside || sign === -1 ? signMark(sign, isInside) : nothing;
  const m = formula(mathml`${mark}${bracketed(expr, isInside || sign === -1)}`);
  if (products.length === 0) return m;
  const ids = products.join(' ');
  return isPresent
    ? html`<button type="button" class="term" data-terms=${ids}
      aria-label=${`${sign === -1 ? '− ' : ''}${plainText(expr)}`}>${m}</button>`
    : html`<span class="term" data-terms=${ids}>${m}</span>`;
}

const signMark = (sign: 1 | -1, isInside: boolean): TemplateResult =>
  mathml`<mo form=${isInside ? 'infix' : 'prefix'}>${sign === -1 ? '−' : '+'}</mo>`;

/** A term, in parentheses if it is a sum behind a sign. */
const bracketed = (expr: Expr, isSigned: boolean): TemplateResult =>
  isSigned && expr.op === 'sum'
    ? mathml`<mo stretchy="false">(</mo>${typesetSymbols(expr)}<mo stretchy="false">)</mo>`
    : typesetSymbols(expr);

const POWERS = [
  mathml`<mn>1</mn>`,
  mathml`<mi>t</mi>`,
  mathml`<msup><mi>t</mi><mn>2</mn></msup>`,
] as const;

/** t²(…) + t(…) + (…) = 0, with the terms of each power. */
function powers(columns: readonly WalkColumn[]): TemplateResult {
  const used = columns.filter(({ parts }) => parts.length > 0);
  return html`${used.map(({ power, parts }, i) => {
    const sign = i > 0 ? signMark(1, true) : nothing;
    const t = power > 0 ? POWERS[power] : nothing;
    const close = i === used.length - 1 ? mathml`<mo>=</mo><mn>0</mn>` : nothing;
    return html`${formula(mathml`${sign}${t}<mo stretchy="false">(</mo>`)}${terms(
      parts,
      false,
      formula(mathml`<mo stretchy="false">)</mo>${close}`),
    )} `;
  })}`;
}

/* The terms of each power as a table: term, numbers put in, value; below a rule their sum. */

function bill(line: WalkLine, columns: readonly WalkColumn[], model: ExploreModel): TemplateResult {
  const shown = model.shown.hits;
  const { numbers } = model.derivation;
  const sum = (letter: string) => numbers.scalars[letter];
  const said = shown ? signWords(model.shape, model.ray) : {};
  return html`<div class="walk-bill" data-tex=${texOf(line)}>
    ${columns.map(
      ({ power, letter, parts }) => html`<div class="walk-column">
        <p class="walk-power">${formula(POWERS[power] ?? POWERS[0])}</p>
        ${parts.map((part, i) => billRow(part, i, numbers, shown))}
        ${parts.length === 0 ? html`<p class="walk-none">no term</p>` : nothing}
        <p class="walk-sum">${formula(
          mathml`<mi data-symbol=${`coefficient-${letter}`}>${letter}</mi><mo>=</mo>`,
        )}
          ${shown ? value(`walk.${letter}`, sum(letter) ?? 0) : html`<span>?</span>`}</p>
      </div>`,
    )}
    ${columns.map(({ letter }) => (said[letter] ? sentence(said[letter]) : nothing))}
  </div>
  <p class="walk-whole">${wholeOf(model.derivation, shown)}</p>`;
}

function billRow(
  part: WalkPart,
  i: number,
  numbers: Values<number>,
  shown: boolean,
): TemplateResult {
  const { sign, expr } = part;
  const plain = { ...part, sign: 1 as const };
  const x = sign * evaluate(expr, float64, numbers);
  const written = putInSideBySide(
    [{ expr, results: [{ value: sign * x, text: null, branch: 1 }] }],
    numbers,
    false,
  );
  return html`<div class="walk-row">
    <span class="walk-plus">${sign === -1 ? '−' : i > 0 ? '+' : ''}</span>
    <span class="walk-term">${term(plain, false, true)}
      ${
        shown && written
          ? html`<span class="walk-numbers">${inNumbers(expr, numbers, written.digits)}</span>`
          : nothing
      }</span>
    ${shown ? value(`walk.term${part.products.join('-')}`, x) : nothing}
  </div>`;
}

/** f(t) with its coefficients as numbers. */
function wholeOf({ f, numbers }: Derivation, shown: boolean): TemplateResult {
  const { A = 0, B = 0, C = 0 } = numbers.scalars;
  const put = signedSum([A, squared(T)], [B, T], [C, null]);
  return formula(mathml`<mi>f</mi><mo stretchy="false">(</mo><mi>t</mi><mo
    stretchy="false">)</mo><mo>=</mo>${typesetSymbols(shown ? put : f)}`);
}

const T = scalar('t');

/** A sum of numbers times trees, each with its sign; terms that are 0 are left out. */
function signedSum(...all: readonly (readonly [number, Expr | null])[]): Expr {
  const terms = all
    .filter(([x]) => x !== 0)
    .map(([x, of]): Term => {
      const size = num(Math.abs(x));
      const expr = of === null ? size : Math.abs(x) === 1 ? of : times(size, of);
      return { sign: x < 0 ? -1 : 1, expr };
    });
  return terms.length > 0 ? { op: 'sum', terms } : num(0);
}

/* A line with its numbers put in, and its value. */

function numbersOf(
  step: Step,
  line: WalkLine,
  model: ExploreModel,
): TemplateResult | typeof nothing {
  const { numbers } = model.derivation;
  const right = walkSide(line.right);
  const left = walkSide(line.left);
  switch (step.id) {
    case 'normal':
      return atHits(left, right, model);
    case 't':
    case 'roots':
      return rootNumbers(model);
    case 'coefficients':
    case 'complete':
      return left.op === 'scalar'
        ? withResult(left.id, right, numbers)
        : step.columns
          ? nothing
          : squareNumbers(line, numbers);
    default:
      return openNumbers(line, numbers);
  }
}

/** The values without t and the equation's point X, which stay symbols. */
const open = ({ scalars, vectors }: Values<number>): Values<number> => ({
  scalars: Object.fromEntries(Object.entries(scalars).filter(([id]) => !/^[txyz]$/.test(id))),
  vectors: Object.fromEntries(Object.entries(vectors).filter(([id]) => id !== 'X')),
});

function openNumbers({ left, right }: WalkLine, numbers: Values<number>): TemplateResult {
  const put = (parts: readonly WalkPart[], behind = '') =>
    inNumbers(walkSide(parts), open(numbers), MOST, behind);
  const line = right.length > 0 ? html`${put(left)} = ${put(right)}` : put(left, '= 0');
  return html`<div class="walk-numbers">${line}</div>`;
}

/** The line of a coefficient, with the kernel's value as its result. */
function withResult(id: string, right: Expr, numbers: Values<number>) {
  const result = numbers.scalars[id];
  if (result === undefined) return nothing;
  const results = [{ value: result, text: null, branch: 1 as const }];
  const written = putInSideBySide([{ expr: right, results }], numbers, false);
  if (!written) return html`<div class="walk-numbers">a number of it is beyond the doubles</div>`;
  const { digits, isFaithful } = written;
  return html`<div class="walk-numbers">${inNumbers(right, numbers, digits)}
    ${isFaithful ? '=' : '≈'} ${value(`walk.${id}`, result)}</div>`;
}

/** f(t) with its numbers, and as a completed square. */
function squareNumbers({ left, right }: WalkLine, numbers: Values<number>) {
  const { A = 0, B = 0, D = 0 } = numbers.scalars;
  const put = (parts: readonly WalkPart[]) => inNumbers(walkSide(parts), numbers, 6);
  if (right.length === 0) return openNumbers({ left, relation: '=', right }, numbers);
  const [turn, height] = [-B / (2 * A), -D / (4 * A)];
  const whole = signedSum([A, squared(signedSum([1, T], [-turn, null]))], [height, null]);
  return html`<div class="walk-numbers">${put(right)}</div>
    <div class="walk-worked">${formula(mathml`<mi>f</mi><mo stretchy="false">(</mo><mi>t</mi><mo
      stretchy="false">)</mo><mo>=</mo>${typesetSymbols(whole)}`)}</div>
    <div class="walk-numbers walk-turn">
      −<i>B</i>/2<i>A</i> = ${value('walk.turn', turn)},
      −<i>D</i>/4<i>A</i> = ${value('walk.height', height)}
    </div>`;
}

/** t with −B, √D and 2A evaluated, as in the algebra. */
function rootNumbers({ derivation, found, exactly }: ExploreModel) {
  const step = derivation.steps.find(({ id }) => id === 't');
  if (!step) return nothing;
  const { expr } = step;
  const lines = [{ expr, results: resultsOf(step, found, exactly) }];
  const written = putInSideBySide(lines, derivation.numbers, true);
  if (!written) return html`<div class="walk-numbers">a number of it is beyond the doubles</div>`;
  const { digits, isFaithful } = written;
  const put = typesetNumbers(expr, derivation.numbers, { worked: true, digits });
  const sign = isFaithful ? '=' : '≈';
  const line = formula(mathml`<mi>t</mi><mo>${sign}</mo>${put}`, true);
  return html`<div class="walk-numbers">${line}</div>`;
}

/** One component of N at each hit. */
function atHits(left: Expr, right: Expr, { derivation, found }: ExploreModel) {
  const { numbers } = derivation;
  const axis = left.op === 'component' ? left.axis : 'x';
  const i = { x: 0, y: 1, z: 2 }[axis] as 0 | 1 | 2;
  return html`${found.hits.map(({ point: [x, y, z], normal }, k) => {
    const there = withScalars(numbers, { x, y, z });
    const results = [{ value: normal[i], text: null, branch: 1 as const }];
    const written = putInSideBySide([{ expr: right, results }], there, false);
    if (!written) return nothing;
    return html`<div class="walk-numbers walk-at-hit"><span>P${subscript(k + 1)}:</span>
      ${inNumbers(right, there, written.digits)} ${written.isFaithful ? '=' : '≈'}
      ${value(`walk.N${k + 1}.${axis}`, normal[i])}</div>`;
  })}`;
}

/** The results of a step: roots, normals, conditions. */
function results(
  { id }: Step,
  model: ExploreModel,
  said: Partial<Record<SignedLine, string>>,
): TemplateResult | typeof nothing {
  const { hits, found, derivation, digits } = model;
  switch (id) {
    case 'expand':
      return html`${(['N·(E − P)', 'N·d'] as const)
        .map((of) => said[of])
        .map((words) => (words ? sentence(words) : nothing))}`;
    case 'complete':
      // If A = 0 there is no square, and the sentence is about a straight line.
      return said.D?.startsWith('D') ? closest(model) : sentence(said.D ?? '');
    case 'roots':
    case 't':
      if (hits.length === 0) return html`<p class="walk-results">There is no root.</p>`;
      return html`<p class="walk-results">${hits.map(
        ({ index, t }) => html`<span>t${subscript(index)} = ${value(`walk.t${index}`, t)}</span> `,
      )}</p>`;
    case 'normal':
      return html`${found.hits.map((hit, i) => normalOf(hit, i, model))}`;
    case 'figure':
      return derivation.conditions.length > 0 ? conditions(derivation, digits) : nothing;
    default:
      return nothing;
  }
}

/** The line's distance from the axis or centre of a round surface. */
function closest({ shape, ray }: ExploreModel): TemplateResult | typeof nothing {
  const words = closestWords(shape, ray);
  return words ? sentence(words) : nothing;
}

/** The course's normal, the one of length 1, and which side the ray meets. */
function normalOf({ normal, singular }: Hit, i: number, { found, exactly, ray }: ExploreModel) {
  const name = `N${subscript(i + 1)}`;
  if (singular) {
    return html`<p class="walk-results">${name} is zero: every derivative vanishes there.</p>`;
  }
  const length = Math.hypot(...normal);
  const facing =
    found.class === exactly.found.class ? facingWords(exactly.found, i, ray.direction) : null;
  const unit = normal.map((x) => x / length) as unknown as typeof normal;
  return html`<p class="walk-results">${name} = ${displayTriple(normal)},
      ${name}/|${name}| = ${displayTriple(unit)}</p>
    ${facing ? sentence(facing) : nothing}`;
}

/** A line with its numbers, in pieces between which it may break; `behind` stays with the last. */
function inNumbers(
  expr: Expr,
  numbers: Values<number>,
  digits: number,
  behind = '',
): TemplateResult {
  const all = typesetNumbersInPieces(expr, numbers, digits).map((m) => formula(m));
  const last = html`<span class="walk-last">${all.at(-1)} ${behind}</span>`;
  return html`${all.slice(0, -1).map((m) => html`${m} `)}${last}`;
}
