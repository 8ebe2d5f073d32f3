import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname } from 'node:path';
import type { FrameLocator, Page } from '@playwright/test';
import { expect, test } from './support/test.ts';

/*
 * Graze in other people's pages, which have another origin here: the site is 127.0.0.1, they are
 * localhost.
 */
test.use({ isolated: true, provoked: /^request to http:\/\/localhost:/ });

const LINK = '#/explore?shape=cone&E=3,1,1&d=-.8,-.2,-.3&lock=c&embed=scene,graph';
/** What a host may forbid without harm: all but the frame and its own scripts. */
const STRICT = (site: string): string =>
  `default-src 'none'; script-src 'unsafe-inline' ${site}; style-src 'unsafe-inline'; ` +
  `frame-src ${site}; font-src ${site}; img-src data:`;

const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
};

let server: Server;
/** What the host's server answers with: its page, and the headers beside it. */
let given = { body: '', policy: '' };

test.beforeAll(async () => {
  server = createServer((request, response) => {
    const path = request.url ?? '';
    const put = (type: string, body: string | Buffer): void => {
      response.setHeader('Content-Type', type);
      response.end(body);
    };
    if (path.startsWith('/reveal/')) {
      const file = `node_modules/reveal.js/dist/${path.slice('/reveal/'.length)}`;
      put(path.endsWith('.css') ? 'text/css' : 'text/javascript', readFileSync(file));
    } else if (path.startsWith('/site/')) {
      // Strangers may have all scripts but what a worker loads.
      const file = path.slice('/site/'.length) || 'index.html';
      if (!/\/worker-/.test(file)) response.setHeader('Access-Control-Allow-Origin', '*');
      put(TYPES[extname(file)] ?? 'text/plain', readFileSync(`dist/site/${file}`));
    } else if (path === '/offline.html') {
      put('text/html', readFileSync('dist/offline/index.html'));
    } else {
      if (given.policy) response.setHeader('Content-Security-Policy', given.policy);
      put('text/html', given.body);
    }
  }).listen(0, '127.0.0.1');
  await once(server, 'listening');
});
test.afterAll(() => server.close());

const origin = (): string => `http://localhost:${(server.address() as AddressInfo).port}`;

/** Opens a page of the host's. */
async function host(page: Page, body: string, policy = ''): Promise<void> {
  const head = '<!doctype html><meta charset="utf-8"><title>A course</title>';
  given = { body: `${head}<link rel="icon" href="data:,">${body}`, policy };
  await page.goto(`${origin()}/course/page.html`);
}

const frame = (src: string, more = ''): string =>
  `<iframe src="${src.replaceAll('&', '&amp;')}" width="640" height="420" ${more}></iframe>`;
/** Keeps every message of the frame in `heard`. */
const LISTEN = `<script>
  const heard = [];
  addEventListener('message', ({ data }) => heard.push(data));
  const say = (data) => document.querySelector('iframe').contentWindow.postMessage(data, '*');
</script>`;

interface Heard {
  readonly type: string;
  readonly [key: string]: unknown;
}
const heard = (page: Page, type: string): Promise<Heard[]> =>
  page.evaluate(`heard.filter((one) => one.type === '${type}')`) as Promise<Heard[]>;
const say = (page: Page, data: unknown): Promise<unknown> =>
  page.evaluate(`say(${JSON.stringify(data)})`);
const lastState = async (page: Page): Promise<Heard | undefined> =>
  (await heard(page, 'state')).at(-1);

/** Both parts stand in the frame, and nothing else of the page does. */
async function standsIn(graze: FrameLocator): Promise<void> {
  await expect(graze.locator('.embed .scene-root')).toBeVisible();
  await expect(graze.locator('.embed .graph-svg')).toBeVisible();
  await expect(graze.locator('header, nav, .controls, .algebra')).toHaveCount(0);
}

test('a page of another origin shows parts, and speaks with them', async ({ page, baseURL }) => {
  const site = baseURL ?? '';
  await host(page, LISTEN + frame(`${site}${LINK}`), STRICT(site));
  const graze = page.frameLocator('iframe');
  await standsIn(graze);
  await expect(graze.getByRole('link', { name: 'Graze' })).toHaveAttribute(
    'href',
    `${site}#/explore?shape=cone&d=-.8,-.2,-.3&method=certified`,
  );
  await expect.poll(() => heard(page, 'ready')).toHaveLength(1);
  await expect.poll(async () => (await heard(page, 'height')).length).toBeGreaterThan(0);

  await test.step('it answers, and tells of changes', async () => {
    await say(page, { graze: 1, type: 'get' });
    await expect.poll(() => lastState(page)).toMatchObject({ graze: 1, class: 'two' });
    await say(page, { graze: 1, type: 'subscribe' });
    await say(page, { graze: 1, type: 'set', state: 'shape=cone&E=3,1,9&d=-1,0,0' });
    await expect.poll(() => lastState(page)).toMatchObject({ class: 'none', t: [] });
    expect((await lastState(page))?.state).toContain('embed=scene,graph');
  });

  await test.step('what it cannot read is said, and what is no message is not heard', async () => {
    const before = (await heard(page, 'error')).length;
    for (const data of [null, 'get', { graze: 2, type: 'get' }, { graze: 1, type: 'eval' }, []]) {
      await say(page, data);
    }
    await say(page, { graze: 1, type: 'set', state: 7 });
    await expect
      .poll(async () => (await heard(page, 'error')).slice(before).map(({ reason }) => reason))
      .toEqual(["state must be a link's text, got 7"]);
    await say(page, { graze: 1, type: 'set', state: 'shape=cone&c=two' });
    await expect
      .poll(async () => (await heard(page, 'error')).at(-1)?.reason)
      .toBe("opened without c: 'two' is not a number");
  });

  await test.step('keys that no control takes are told to the host', async () => {
    await say(page, { graze: 1, type: 'reset' });
    await expect.poll(async () => (await lastState(page))?.state).toContain('d=-.8,-.2,-.3');
    const before = (await lastState(page))?.state;
    await graze.locator('.scene-root').focus();
    for (const key of ['ArrowRight', 'PageDown', 'PageUp', 'Escape']) {
      await page.keyboard.press(key);
    }
    await graze.getByRole('slider', { name: /^E/ }).first().focus();
    await page.keyboard.press('PageDown');
    await expect
      .poll(async () => (await heard(page, 'key')).map(({ key }) => key))
      .toEqual(['ArrowRight', 'PageDown', 'PageUp', 'Escape', 'PageDown']);
    expect((await lastState(page))?.state).toBe(before);
  });

  await test.step('a frame that is loaded anew has its state again', async () => {
    await graze.getByRole('slider', { name: /^E/ }).first().press('ArrowRight');
    await expect.poll(async () => (await lastState(page))?.state).toContain('E=3.1,1,1');
    const moved = (await lastState(page))?.state;
    const src = await page.locator('iframe').getAttribute('src');
    await page.evaluate(`heard.length = 0; document.querySelector('iframe').src = 'about:blank'`);
    await expect(page.frameLocator('iframe').locator('.embed')).toHaveCount(0);
    await page.evaluate(`document.querySelector('iframe').src = ${JSON.stringify(src)}`);
    await standsIn(graze);
    await expect.poll(() => heard(page, 'ready')).toHaveLength(1);
    await say(page, { graze: 1, type: 'get' });
    await expect.poll(async () => (await lastState(page))?.state).toBe(moved);
  });
});

test('a sandboxed frame, of the site and of the single file', async ({ page, baseURL }) => {
  const two = [`${baseURL}${LINK}`, `${origin()}/offline.html${LINK}`];
  await host(page, two.map((src) => frame(src, 'sandbox="allow-scripts"')).join(''));
  for (const i of [0, 1]) await standsIn(page.frameLocator('iframe').nth(i));
  await test.step('what cannot be started there is said', async () => {
    await host(page, frame(`${origin()}/site/#/picture`, 'sandbox="allow-scripts"'));
    const words = 'failed: a worker could not be started';
    await expect(page.frameLocator('iframe').locator('main').getByText(words)).toBeVisible();
  });
  await test.step('its workers trace and measure, and a program runs', async () => {
    const shown = page.frameLocator('iframe');
    const sites = [baseURL ?? '', `${origin()}/offline.html`];
    for (const site of sites) {
      const open = (link: string): Promise<void> =>
        host(page, frame(`${site}${link}`, 'sandbox="allow-scripts"'));
      await open('#/picture?scene=plain&size=64x36');
      await expect(shown.locator('.picture')).toHaveAttribute('data-trace', 'finished');
      await open('#/accuracy?shape=sphere&atlas=E.z,E.x');
      await expect(shown.locator('.atlas-sentence').first()).toContainText('the right class');
      await open('#/check?part=program');
      await shown.getByRole('button', { name: 'Run', exact: true }).click();
      await expect(shown.locator('.program-report')).toHaveAttribute('data-finished', '1');
    }
  });
});

test('all of Graze in a frame tells the score', async ({ page, baseURL }) => {
  await host(page, LISTEN + frame(`${baseURL}#/check?seed=4&theme=dark`));
  const graze = page.frameLocator('iframe');
  await expect(graze.locator('html')).toHaveAttribute('data-theme', 'dark');
  await expect
    .poll(async () => (await heard(page, 'score')).at(-1))
    .toMatchObject({ right: 0, asked: expect.any(Number) });
  const summary = graze.locator('main .summary');
  await summary.locator('summary').click();
  await expect(summary).toContainText('The page around this one is told how many are right');
});

test('a frame that is higher than its content says so', async ({ page, baseURL }) => {
  await host(page, LISTEN + frame(`${baseURL}#/explore?shape=cone&embed=caption,hits`));
  const px = async (): Promise<unknown> => (await heard(page, 'height')).at(-1)?.px;
  await expect.poll(px).toBeLessThan(300);
  expect(await px()).toBeGreaterThan(60);
});

const ELEMENT = (site: string): string =>
  `<script type="module" src="${site}embed/graze.js"></script>`;

test('two elements on one page, live and apart', async ({ page, baseURL }) => {
  const site = baseURL ?? '';
  // As a static site of lecture notes styles it: text, buttons, drawings and boxes of its own.
  const body = `<body class="fullcontent"><style>graze-ray { height: 420px }
      body { font: 30px/3 cursive; text-align: center; letter-spacing: 2px; color: red }
      svg, canvas { max-width: 40%; border: 3px solid } button, input { padding: 20px }
      * { box-sizing: content-box; --E: lime }</style>
    <main class="content" id="quarto-document-content"><h1>A course page</h1>
    <graze-ray id="a" shape="cone" E="3,1,1" d="-.8,-.2,-.3" show="scene,graph" lock="c">
    </graze-ray>
    <graze-ray id="b" shape="sphere" show="parameters,algebra,hits" theme="dark"></graze-ray>
    <script>const told = [];
      addEventListener('DOMContentLoaded', () => document.querySelector('#a')
        .addEventListener('change', ({ detail }) => told.push(detail)));</script>`;
  await host(page, body + ELEMENT(site), STRICT(site));
  const [a, b] = [page.locator('#a'), page.locator('#b')];
  await expect(a.locator('.scene-root')).toBeVisible();
  await expect(b.locator('[data-quantity="class"]')).toBeVisible();
  await expect(b.locator('.scene-root, .graph')).toHaveCount(0);
  expect(await a.evaluate((element) => (element as HTMLElement).offsetHeight)).toBe(420);
  await expect(a.locator('.embed-title, .graph').first()).toHaveCSS('letter-spacing', 'normal');
  await expect(b.locator('.controls')).toHaveCSS('text-align', 'start');
  await expect(b.locator('#box-E\\.x input')).toHaveCSS('padding-top', '0px');
  // Nothing of it is in the host's own document.
  await expect(page.locator('head link[rel=stylesheet], head style')).toHaveCount(0);

  await test.step('an attribute and the property move it, and it tells', async () => {
    await a.evaluate((element) => element.setAttribute('E', '3,1,9'));
    await expect.poll(() => page.evaluate('told.at(-1)?.class')).toBe('none');
    await a.evaluate((element) => {
      (element as HTMLElement & { state: string }).state = 'shape=sphere&E=9,1,0&d=-1,0,0';
    });
    await expect.poll(() => page.evaluate('told.at(-1)')).toMatchObject({ class: 'two' });
    await expect(b.locator('[data-quantity="E.x"]')).toHaveAttribute('data-value', '3');
  });

  await test.step('what one lights, the other does not', async () => {
    await b.locator('#box-E\\.x input').focus();
    await expect(b.locator('.lit').first()).toBeVisible();
    await expect(a.locator('.lit')).toHaveCount(0);
  });

  await test.step('a number typed in one is its own', async () => {
    await b.locator('#box-E\\.x input').fill('9');
    await page.keyboard.press('Enter');
    await expect(b.locator('[data-quantity="E.x"]')).toHaveAttribute('data-value', '9');
    const stateOf = (element: Element) => (element as HTMLElement & { state: string }).state;
    expect(await b.evaluate(stateOf)).toBe('shape=sphere&E=9,1,1&method=certified');
    expect(await a.evaluate(stateOf)).toContain('E=9,1,0');
  });

  await test.step('out of the page and in again', async () => {
    await b.evaluate((element) => {
      const { parentElement } = element;
      element.remove();
      parentElement?.append(element);
    });
    await expect(b.locator('[data-quantity="E.x"]')).toHaveAttribute('data-value', '9');
  });
});

test('a deck walks on through the element and through a frame', async ({ page, baseURL }) => {
  const site = baseURL ?? '';
  await host(
    page,
    `<link rel="stylesheet" href="/reveal/reveal.css">
    <div class="reveal"><div class="slides">
      <section><graze-ray shape="cone" show="scene" style="height:300px"></graze-ray></section>
      <section>${frame(`${site}${LINK}`)}</section>
      <section><h2>The end</h2></section>
    </div></div>
    <script type="module">
      import Reveal from '/reveal/reveal.esm.js';
      Reveal.initialize({ transition: 'none', hash: false });
      window.Reveal = Reveal;
      addEventListener('message', ({ data }) => {
        if (data?.graze !== 1 || data.type !== 'key') return;
        if (data.key === 'PageDown') Reveal.next();
        if (data.key === 'PageUp') Reveal.prev();
      });
    </script>${ELEMENT(site)}`,
  );
  const slide = () => page.evaluate('window.Reveal?.getIndices().h');
  await page.locator('graze-ray .scene-root').focus();
  expect(await slide()).toBe(0);
  await page.keyboard.press('PageDown');
  await expect.poll(slide).toBe(1);
  await page.frameLocator('iframe').locator('.scene-root').focus();
  await page.keyboard.press('PageDown');
  await expect.poll(slide).toBe(2);
  await page.keyboard.press('PageUp');
  await expect.poll(slide).toBe(1);
});

test('a notebook\u2019s model and the element keep in step', async ({ page, baseURL }) => {
  const site = baseURL ?? '';
  await host(
    page,
    `<div id="cell"></div><script type="module">
      import widget, { render } from '${site}embed/graze.js';
      const values = { state: 'shape=sphere&E=5,1,0&d=-1,0,0', show: 'parameters,algebra' };
      const listeners = new Set();
      window.saved = 0;
      window.model = {
        get: (name) => values[name],
        set: (name, value) => { values[name] = value; },
        save_changes: () => { window.saved++; },
        on: (_, listener) => listeners.add(listener),
        off: (_, listener) => listeners.delete(listener),
        told: () => { for (const listener of listeners) listener(); },
      };
      window.same = widget.render === render;
      window.leave = render({ model: window.model, el: document.querySelector('#cell') });
    </script>`,
  );
  const ray = page.locator('graze-ray');
  await expect(ray.locator('[data-quantity="class"]')).toHaveAttribute('data-value', 'two');
  expect(await page.evaluate('window.same')).toBe(true);
  await page.evaluate(`model.set('state', 'shape=sphere&E=5,9,0&d=-1,0,0'); model.told()`);
  await expect(ray.locator('[data-quantity="class"]')).toHaveAttribute('data-value', 'none');
  await ray.locator('#box-E\\.y input').fill('1');
  await page.keyboard.press('Enter');
  await expect.poll(() => page.evaluate('model.get("class")')).toBe('two');
  expect(await page.evaluate('window.saved')).toBeGreaterThan(0);
  await page.evaluate('window.leave()');
  await expect(ray).toHaveCount(0);
});
