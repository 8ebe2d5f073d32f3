import { open, quantities } from './support/page.ts';
import { expect, visit as test } from './support/test.ts';

test.describe.configure({ mode: 'default' });

const MARKUP = '<img src=x onerror="globalThis.broken=1"><script>globalThis.broken=2</script>';
const HOSTILE: readonly string[] = [
  `#/explore?shape=${MARKUP}`,
  `#/explore?${MARKUP}=1&E=${MARKUP}`,
  `#/explore?shape=${encodeURIComponent(MARKUP)}&view=${encodeURIComponent(MARKUP)}`,
  `#/${MARKUP}`,
  '#javascript:globalThis.broken=3',
  '#/explore?__proto__=1&constructor=2&shape=__proto__&method=constructor',
  '#/explore?shape=constructor&E=toString,valueOf,__proto__&axis=__proto__',
  '#/explore?E=constructor.constructor("globalThis.broken=4")(),0,0',
  '#/explore?E=%00,%ZZ,%E0%A4%A&d=%&%=%',
  '#/explore?E=((((((((((((((((((((1,2,3&d=1;globalThis.broken=5;,0,0',
  `#/explore?${'&'.repeat(5000)}shape=cone`,
  `#/explore?E=${'9'.repeat(1_000_000)}`,
  `#/explore?${'k=1&'.repeat(200_000)}`,
];

test('a hostile link runs nothing and makes no element', async ({ page }) => {
  await open(page, '#/explore?shape=cone&method=exact');
  for (const hash of HOSTILE) {
    await open(page, hash);
    const found = await page.evaluate(() => ({
      made: document.querySelectorAll('body :is(img, iframe, object, embed, script:not([src]))')
        .length,
      ran: 'broken' in globalThis,
      polluted: Object.keys(Object.prototype),
      length: document.body.innerText.length,
    }));
    expect(found, hash.slice(0, 80)).toMatchObject({ made: 0, ran: false, polluted: [] });
    expect(found.length, hash.slice(0, 80)).toBeLessThan(10_000);
    expect((await quantities(page)).class).toBeTruthy();
  }
});

test('hostile links do no harm either when the page is opened with them', async ({ page }) => {
  for (const hash of [HOSTILE[0], HOSTILE[8], HOSTILE[11]]) {
    await page.goto('about:blank');
    await page.goto(`./${hash}`);
    await page.locator('[data-quantity="class"]').waitFor();
    expect(await page.evaluate(() => 'broken' in globalThis)).toBe(false);
    expect((await quantities(page))['E.x']).toBe('3');
  }
});
