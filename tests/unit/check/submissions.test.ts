import { expect, test } from 'vitest';
import { submissionsAmong } from '../../../src/check/program/submissions.ts';

const found = (...paths: string[]) =>
  submissionsAmong(paths.map((path) => ({ path }))).map(({ who, file, problem }) => [
    who,
    file?.path ?? problem,
  ]);

test('a file is a submission by its name, a folder by its own', () => {
  expect(found('s10.js', 's9.ts')).toEqual([
    ['s9', 's9.ts'],
    ['s10', 's10.js'],
  ]);
  expect(found('class/ada/intersect.js', 'class/ada/test.js', 'class/bo.json')).toEqual([
    ['ada', 'class/ada/intersect.js'],
    ['bo', 'class/bo.json'],
  ]);
  // Two folders that were dropped side by side, and one alone.
  expect(found('ada/a.js', 'bo/b.csv')).toEqual([
    ['ada', 'ada/a.js'],
    ['bo', 'bo/b.csv'],
  ]);
  expect(found('ada/a.js')).toEqual([['ada', 'ada/a.js']]);
  expect(found('class/ada/a.js')).toEqual([['ada', 'class/ada/a.js']]);
  expect(found('x/ada/a.js', 'x/ada/b.js', 'x/bo/1.png', 'x/ada.ts')).toEqual([
    ['ada', 'x/ada.ts'],
    ['ada (2)', 'several files in this folder could be meant: a.js, b.js'],
    ['bo', 'nothing in this folder can be graded'],
  ]);
  expect(found()).toEqual([]);
});
