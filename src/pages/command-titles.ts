import { SHAPES } from '../math/index.ts';

/** Titles of the commands in the help, which is loaded when it is opened. */
const TITLES: Readonly<Record<string, string>> = {
  next:
    'next: the next step while deriving; else reveal the next line, the ' +
    'answer, or the next example',
  previous:
    'back: the step before while deriving; else take away the last line, hide ' +
    'the answer, or the example before',
  answer: 'show the answer to the example’s question; or hide it',
  gallery: 'examples',
  derive: 'derive A, B, C, the roots and N step by step; or close that',
  hide: 'hide the results, to predict them; or show them all',
  reveal: 'reveal the next line',
  ghost: 'keep this ray as a ghost to compare with; or drop it',
  second: 'show a second view beside the scene, on a wide window; or hide it',
  play: 'play the bead along the ray; or stop it',
  hear: 'hear f along the ray, once; any key stops it',
  reset: 'reset everything',
  'lesson-next': 'next: show what is hidden or asked, or the next step',
  'lesson-back': 'back: hide what was shown, or the step before',
  present: 'open the presenter’s window: notes, what comes next, a clock',
  'present-explore': 'open the presenter’s window: all values, what comes next, a clock',
  'picture-more': 'build the picture up: one effect more; from a whole one, camera rays alone',
  'picture-less': 'take the last effect of the picture away',
  collect: 'add what is shown to your own lesson, as its next step',
  undo: 'undo',
  redo: 'redo',
  link: 'copy the link',
  save: 'save as a file',
  open: 'open a file',
  export: 'copy or save the derivation, code, picture',
  theme: 'next theme: system, light, dark, projector',
  full: 'full screen',
  black: 'black screen; one of these keys, Escape, Page Down, Page Up or a click ends it',
  help: 'help',
};

/** The title of a command by its id; undefined for an unknown one. */
export const commandTitle = (id: string): string | undefined =>
  TITLES[id] ?? SHAPES.find(({ kind }) => id === `shape-${kind}`)?.title;
