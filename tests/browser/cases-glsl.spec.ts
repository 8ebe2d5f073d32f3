import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { casesText, familiesFrom } from '../../scripts/cases/cases.ts';
import { SHAPES } from '../../src/math/index.ts';
import { expect, test } from './support/test.ts';

/* The runner of hard cases for GLSL, in WebGL2 of this browser. */

const FILE = new URL('../../scripts/cases/graze_cases.html', import.meta.url);
const FAMILIES = familiesFrom('typical,sphere,sphere-far');

test.use({ ink: true });

/** Right for spheres, as far as 32 bits go; −1 for all else. */
const SPHERE = (verdict: string): string => `
int intersect(Shape shape, vec3 E, vec3 d, out float t[2]) {
  if (shape.kind != SPHERE) return -1;
  vec3 p = E - shape.center;
  float A = dot(d, d);
  float b = dot(d, p);
  float D = b * b - A * (dot(p, p) - shape.radius * shape.radius);
  if (${verdict}) return 0;
  float q = -b - (b < 0.0 ? -1.0 : 1.0) * sqrt(D);
  float C = dot(p, p) - shape.radius * shape.radius;
  t[0] = min(q / A, C / q);
  t[1] = max(q / A, C / q);
  return 2;
}`;

async function judged(page: Page, cases: string, source: string, ulps: number) {
  await page.locator('#cases').setInputFiles({
    name: 'cases.json',
    mimeType: 'application/json',
    buffer: Buffer.from(cases),
  });
  await page.locator('#source').fill(source);
  await page.locator('#ulps').fill(String(ulps));
  await page.locator('#run').click();
  await expect(page.locator('#said')).not.toBeEmpty();
  return (await page.locator('#said').textContent()) ?? '';
}

async function made(page: Page, name: string): Promise<string> {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('link', { name }).click(),
  ]);
  return readFileSync(await download.path(), 'utf8');
}

test('judges GLSL in 32 bits, and reports as the other runners do', async ({ page }) => {
  const asked = { families: FAMILIES, seed: 7, count: 60 };
  const text = casesText({ ...asked, float32: true });
  const { cases } = JSON.parse(text);
  const spheres = cases.filter(({ shape }: { shape: { kind: string } }) => shape.kind === 'sphere');
  expect(spheres.length).toBeGreaterThan(10);
  await page.goto(FILE.href);

  // Its kinds and fields are those of the registry.
  const known = await page.evaluate('[KINDS, VECTORS, NUMBERS]');
  const params = SHAPES.flatMap((entry) => [...entry.params]);
  const keys = (type: string) => [
    ...new Set(params.filter((one) => one.type === type).map(({ key }) => key as string)),
  ];
  expect(known).toEqual([
    SHAPES.map(({ kind }) => kind),
    expect.arrayContaining(keys('vector')),
    expect.arrayContaining(keys('number')),
  ]);

  const right = await judged(page, text, SPHERE('D < 0.0'), 2 ** 23);
  const [, passed = 0, failed = 0, skipped = 0] = (
    right.match(/^(\d+) passed, (\d+) failed, (\d+) skipped$/) ?? []
  ).map(Number);
  expect([passed + failed, skipped]).toEqual([spheres.length, cases.length - spheres.length]);
  expect(passed).toBeGreaterThan(0);
  const xml = await made(page, 'junit.xml');
  expect(xml).toContain(`tests="${cases.length}" failures="${failed}" skipped="${skipped}"`);
  expect(
    await page.evaluate(
      (it) => new DOMParser().parseFromString(it, 'text/xml').querySelectorAll('testcase').length,
      xml,
    ),
  ).toBe(cases.length);
  const report = await made(page, 'report.markdown');
  for (const { id } of FAMILIES) expect(report).toContain(`| ${id} | 60 | `);

  // A program that finds nothing is wrong wherever something is to be found.
  const none = await judged(page, text, SPHERE('true'), 2 ** 23);
  const hit = spheres.filter(({ hits }: { hits: unknown[] }) => hits.length > 0);
  expect(none).toContain(`${hit.length} failed`);
  // Nothing is right to no unit at all but by chance.
  expect(await judged(page, text, SPHERE('D < 0.0'), 0)).not.toBe(right);

  // What is wrong is said.
  expect(await judged(page, casesText(asked), SPHERE('D < 0.0'), 1)).toContain('--float32');
  expect(await judged(page, '{}', SPHERE('D < 0.0'), 1)).toContain('no hard cases');
  expect(await judged(page, text, 'int intersect(', 1)).toContain('ERROR');
});
