/** One line on what a method does, shown under its name. A method without one shows its `idea`. */
export const HINTS: Readonly<Record<string, string>> = {
  textbook32: 'every step with 24 bits',
  textbook: '(−B ± √D) / 2A with 53 bits',
  stable: 'q = −(B ± √D)/2, then q/A and C/q',
  moment: 'D from d × (E − C), then q',
  compensated: 'A, B, C, D with 106 bits',
  interval: 'a bound below and above each step',
  certified: 'a filter, then more digits if needed',
  exact: 'whole numbers, rounded once',
};
