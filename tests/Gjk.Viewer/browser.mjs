// A page in headless Chromium. Everything that the page complains about or fetches is recorded.
import { chromium } from 'playwright-core';
import { pathToFileURL } from 'node:url';

// Without a graphics card only what a page draws in 3D needs the emulated one; all else is faster without it.
export const FLAGS = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--disable-gpu-rasterization',
  '--disable-gpu-compositing',
];

/** How long a page may take to do what a check waits for: a slow machine with other work is no fault of a page. */
export const PATIENCE_MS = 180_000;

/** The pause before a page is asked again. */
const PAUSE_MS = 25;

/** The look that most checks use. */
const WIDE = { viewport: { width: 1280, height: 800 }, colorScheme: 'dark' };

/** A phone: narrow, and touched by fingers. */
export const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, colorScheme: 'dark' };

export const startBrowser = () =>
  chromium.launch({ executablePath: process.env.CHROMIUM, headless: true, args: FLAGS });

/** Opens a page from the disk, offline, and waits until it has drawn itself in its window. */
export async function openPage(browser, file, look = WIDE, hash = '') {
  const context = await browser.newContext(look);
  context.setDefaultTimeout(PATIENCE_MS);
  await context.setOffline(true);
  const page = await context.newPage();
  const url = pathToFileURL(file).href + hash;
  page.complaints = [];
  page.on('console', (message) => {
    if (message.type() === 'error') page.complaints.push(message.text());
  });
  page.on('pageerror', (error) => page.complaints.push(String(error)));
  page.on('request', (request) => {
    const isOwn = request.url() === url.split('#')[0] || request.url().startsWith('data:');
    if (!isOwn) page.complaints.push(`fetched ${request.url()}`);
  });
  await page.goto(url);
  await until(page, () => Boolean(window.__gjk));
  await settled(page);
  return page;
}

/** Waits until each canvas fills its place, and nothing is left to draw. */
export const settled = (page) =>
  until(page, () => (window.__gjk.stages ?? []).every((stage) => stage.isSettled));

/** Asks the page until it says yes: waitForFunction would evaluate a string, which the page's own policy forbids. */
export async function until(page, predicate, milliseconds = PATIENCE_MS) {
  const end = Date.now() + milliseconds;
  while (!(await page.evaluate(predicate))) {
    if (Date.now() > end) throw new Error(`never came true: ${predicate}`);
    await pause();
  }
}

/** Repeats a check until it holds, and returns what it returns: a page answers an event when it comes to it. */
export async function eventually(body, milliseconds = PATIENCE_MS) {
  const end = Date.now() + milliseconds;
  for (;;) {
    try {
      return await body();
    } catch (error) {
      if (Date.now() > end) throw error;
      await pause();
    }
  }
}

/** Moves the pointer to a place, which is asked for anew each time, until what is under it satisfies the check. */
export function hover(page, place, check) {
  return eventually(async () => {
    const { x, y } = await place();
    await page.mouse.move(x + 1, y);
    await page.mouse.move(x, y);
    return check(await page.locator('.tip').innerText());
  });
}

const pause = () => new Promise((resolve) => setTimeout(resolve, PAUSE_MS));

/** The page of each browser that decodes pictures, in a context of its own: it must not cover what is looked at. */
const readers = new WeakMap();

/** The colour that a screenshot shows at points, each the mean of some pixels around it. */
export async function colorsAt(page, points, size = 3) {
  await page.evaluate(() => window.__gjk.drawNow());
  const corners = points.map((point) => ({ x: Math.round(point.x), y: Math.round(point.y) }));
  const [left, top] = ['x', 'y'].map((axis) => Math.max(0, Math.min(...corners.map((p) => p[axis])) - size));
  const [right, bottom] = ['x', 'y'].map((axis) => Math.max(...corners.map((p) => p[axis])) + size);
  const clip = { x: left, y: top, width: right - left, height: bottom - top };
  const picture = (await page.screenshot({ clip })).toString('base64');
  const browser = page.context().browser();
  if (!readers.has(browser)) readers.set(browser, browser.newContext().then((context) => context.newPage()));
  const reader = await readers.get(browser);
  return reader.evaluate(
    async ([base64, places, side]) => {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
      const context2d = canvas.getContext('2d');
      context2d.drawImage(image, 0, 0);
      return places.map(({ x, y }) => {
        const corner = [x, y].map((at) => at - Math.floor(side / 2));
        const { data } = context2d.getImageData(...corner, side, side);
        return [0, 1, 2].map((channel) => {
          let sum = 0;
          for (let i = channel; i < data.length; i += 4) sum += data[i];
          return sum / (side * side);
        });
      });
    },
    [picture, corners.map(({ x, y }) => ({ x: x - left, y: y - top })), size],
  );
}

export const isRed = ([r, g, b]) => r > 1.6 * g && r > 1.6 * b;
export const isGreen = ([r, g, b]) => g > 1.3 * r && g > 1.15 * b;

/** How bright a colour is, from 0 to 255. */
export const brightness = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
