import { SHAPES } from '../../src/math/index.ts';
import { PRESETS } from '../../src/scene/presets/index.ts';
import { PAGES } from '../../src/state/state.ts';
import type { Tourist } from './webdriver.ts';

/* Once over all pages, in any browser. What can be compared is given back under a name. */

export type Seen = Record<string, string>;

const PROGRAM = `function intersect(shape, ray) {
  const [px, , pz] = ray.origin.map((x, i) => x - shape.center[i]);
  const [dx, , dz] = ray.direction;
  const A = dx * dx + dz * dz;
  const B = 2 * (px * dx + pz * dz);
  const C = px * px + pz * pz - shape.radius * shape.radius;
  const D = B * B - 4 * A * C;
  if (D < 0) return { t: [] };
  return { t: [-1, 1].map((s) => (-B + s * Math.sqrt(D)) / (2 * A)) };
}`;
const PATIENCE_MS = 240_000;
const PICTURE = 'size=64x36';

export async function tour(browser: Tourist, url: string): Promise<Seen> {
  const seen: Seen = {};
  await browser.goto(url);
  const open = async (hash: string): Promise<void> => {
    await browser.run((next) => {
      location.hash = next;
    }, hash);
    await drawn(browser);
  };
  await until(browser, 'main [data-quantity]');
  for (const { kind } of SHAPES) {
    await open(`#/explore?shape=${kind}`);
    seen[`values of the ${kind}`] = await quantities(browser);
    await browser.run(() => {
      const input = document.querySelector('graze-slider input') as HTMLInputElement;
      input.value = '2.4';
      input.dispatchEvent(new Event('input', { bubbles: true }));
    });
    await drawn(browser);
    seen[`${kind}, after a slider`] = await quantities(browser);
  }
  await browser.run(() => {
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key: '4', bubbles: true }));
  });
  await drawn(browser);
  const before = await quantities(browser);
  seen['values after a key'] = before;
  const hash = await browser.run(() => {
    dispatchEvent(new Event('pagehide'));
    return location.hash;
  });
  await open('#/explore?shape=plane');
  await open(hash);
  if ((await quantities(browser)) !== before) throw new Error(`another state came back by ${hash}`);

  await click(browser, 'File and export');
  await until(browser, 'dialog[open] tr[data-export]');
  seen['what can be taken away'] = await browser.run(() => {
    const rows = [...document.querySelectorAll<HTMLElement>('dialog[open] tr[data-export]')];
    document.querySelector<HTMLElement>('dialog[open] .dialog-head button')?.click();
    return rows.map((row) => row.dataset.export).join();
  });

  await open('#/accuracy?shape=cone');
  await until(browser, '.ladder tbody tr');
  seen['the ladder'] = await browser.run(() =>
    [...document.querySelectorAll<HTMLElement>('.ladder tr [data-quantity]')]
      .map(({ dataset }) => `${dataset.quantity}=${dataset.value}`)
      .filter((pair) => !/^(simd|typescript)/.test(pair))
      .join('\n'),
  );
  // It measures by itself, and shows the reference until then.
  await until(browser, '.plot-mark');

  for (const { id } of PRESETS) {
    await open(`#/picture?scene=${id}&${PICTURE}`);
    await until(browser, '[data-trace=finished], [data-trace=failed]');
    seen[`the picture ${id}`] = await browser.run(() => {
      if (document.querySelector('[data-trace=failed]')) {
        throw new Error(document.querySelector('.picture-status')?.textContent ?? 'failed');
      }
      const canvas = document.querySelector('canvas.traced') as HTMLCanvasElement;
      const { width, height } = canvas;
      const pixels = canvas.getContext('2d')?.getImageData(0, 0, width, height).data ?? [];
      let sum = 0;
      for (const level of pixels) sum = (Math.imul(sum, 31) + level) | 0;
      return `${width} × ${height}, ${sum}`;
    });
  }

  await open('#/check?part=program&cases=cylinder');
  await until(browser, '.program-report');
  await browser.run((program) => {
    const box = document.querySelector('textarea') as HTMLTextAreaElement;
    box.value = program;
    box.dispatchEvent(new Event('input', { bubbles: true }));
  }, PROGRAM);
  await click(browser, 'Run');
  await until(browser, '.program-report[data-finished="1"]');
  seen['what the program got'] = await browser.run(
    () =>
      document
        .querySelector('.program-report')
        ?.textContent?.match(/\d+ of \d+/g)
        ?.join() ?? '',
  );

  // Not every window can be made as narrow as a phone; a frame can.
  for (const { id: page } of PAGES.filter((one) => !('part' in one))) {
    const hash = `#/${page}${page === 'picture' ? `?${PICTURE}` : ''}`;
    await browser.run((to) => {
      document.querySelector('#phone')?.remove();
      const frame = document.createElement('iframe');
      Object.assign(frame, { id: 'phone', width: '390', height: '844' });
      frame.src = new URL(`./${to}`, location.href).href;
      document.body.append(frame);
      return new Promise<void>((done) => {
        const look = (): void => {
          const ready = frame.contentDocument?.querySelector('main [data-quantity], main h2');
          if (ready) done();
          else setTimeout(look, 100);
        };
        look();
      });
    }, hash);
    await drawn(browser);
    seen[`${page} on 390 px`] = await browser.run(() => {
      const inside = document.querySelector<HTMLIFrameElement>('#phone')?.contentWindow;
      if (!inside) throw new Error('no frame');
      const { scrollWidth } = inside.document.documentElement;
      return scrollWidth <= inside.innerWidth ? 'fits' : `${scrollWidth} px wide`;
    });
  }
  return seen;
}

const quantities = (browser: Tourist): Promise<string> =>
  browser.run(() =>
    [...document.querySelectorAll<HTMLElement>('[data-quantity]')]
      .map(({ dataset }) => `${dataset.quantity}=${dataset.value}`)
      .join('\n'),
  );

const drawn = (browser: Tourist): Promise<void> =>
  browser.run(
    () =>
      new Promise<void>((done) => {
        // The hash's event is a task of its own; what it changes is drawn in the frame after it.
        setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(() => done())), 60);
      }),
  );

async function until(browser: Tourist, selector: string): Promise<void> {
  await browser.run(
    ({ selector: wanted, patience }) =>
      new Promise<void>((done, fail) => {
        const end = performance.now() + patience;
        const look = (): void => {
          if (document.querySelector(wanted)) done();
          else if (performance.now() > end) fail(new Error(`${wanted} did not come`));
          else setTimeout(look, 100);
        };
        look();
      }),
    { selector, patience: PATIENCE_MS },
  );
}

const click = (browser: Tourist, name: string): Promise<void> =>
  browser.run((wanted) => {
    const buttons = [...document.querySelectorAll('button')];
    const found = buttons.find(
      (button) =>
        button.getClientRects().length > 0 &&
        (button.getAttribute('aria-label') ?? button.textContent ?? '').trim() === wanted,
    );
    if (!found) throw new Error(`no button ${wanted}`);
    found.click();
  }, name);
