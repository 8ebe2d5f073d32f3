import type { Export } from './define.ts';
import { glsl } from './glsl.ts';
import { latex } from './latex.ts';
import { mathml } from './mathml.ts';
import { python } from './python.ts';
import { typescript } from './typescript.ts';
import { vitest } from './vitest.ts';

/** Every export there is, in the order of the menu. A new one is one new file and one word here. */
export const EXPORTS: readonly Export[] = [latex, mathml, typescript, python, glsl, vitest];
