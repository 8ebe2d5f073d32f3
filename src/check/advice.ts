/** Notations that are not read, each with what to write instead. */
const FORMS: readonly (readonly [RegExp, string])[] = [
  [/[=≈]/, 'type the value alone, without a name before it'],
  [/\|/, 'separate the three numbers by commas or semicolons'],
  [/<|>/, 'write three numbers in round brackets'],
  [/\d\s*[ijk]\b/i, 'write three numbers, such as 3, -6, -5'],
  [/\d\s*(sqrt|√)/i, 'write 2*sqrt(3), with the sign of multiplication'],
  [/\d\s+\d+\s*\/\s*\d/, 'write a mixed number as a sum, 3 + 5/6'],
  [/\)\s*\//, 'divide each of the three numbers by itself'],
];

/** What to write in place of a text that could not be read; '' where nothing is known. */
export function adviceFor(text: string, isNumber: boolean): string {
  // A space is read as a separator in a point, but as a mixed number in a single number.
  const usable = isNumber ? FORMS.filter(([, advice]) => !advice.includes('three')) : FORMS;
  return usable.find(([form]) => form.test(text))?.[1] ?? '';
}
