/** Keeps the result of the last call while every argument is the same by reference. */
export function memoise<Args extends readonly unknown[], R>(
  f: (...args: Args) => R,
): (...args: Args) => R {
  let last: { args: Args; result: R } | null = null;
  return (...args) => {
    if (last?.args.every((arg, i) => Object.is(arg, args[i]))) return last.result;
    last = { args, result: f(...args) };
    return last.result;
  };
}
