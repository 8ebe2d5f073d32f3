/** A typed expression as a tree; evaluated in doubles here, exactly by the math module. */
export type Typed =
  | { readonly op: 'number'; readonly text: string }
  | { readonly op: 'constant'; readonly name: ConstantName }
  | { readonly op: 'unit'; readonly name: UnitName; readonly of: Typed }
  | TypedUnary
  | TypedBinary;

/** A sign or a function. `argument` is the text behind its name. */
export interface TypedUnary {
  readonly op: 'unary';
  readonly name: string;
  readonly argument: string;
  readonly of: Typed;
}

export interface TypedBinary {
  readonly op: 'binary';
  readonly name: string;
  readonly left: Typed;
  readonly right: Typed;
}

export type ConstantName = 'pi' | 'infinity';
export type UnitName = 'deg' | 'rad';
