// A page in headless Chromium. Everything that the page complains about or fetches is recorded.
import { chromium } from 'playwright-core';
import { pathToFileURL } from 'node:url';

const FLAGS = [
  '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync',
  '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
];

export async function startBrowser() {
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, headless: true, args: FLAGS });
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  await context.setOffline(true);
  return { browser, context };
}

export async function openPage(context, file) {
  const page = await context.newPage();
  const url = pathToFileURL(file).href;
  page.complaints = [];
  page.on('console', (message) => { if (message.type() === 'error') page.complaints.push(message.text()); });
  page.on('pageerror', (error) => page.complaints.push(String(error)));
  page.on('request', (request) => {
    if (request.url() !== url && !request.url().startsWith('data:')) page.complaints.push(`fetched ${request.url()}`);
  });
  await page.goto(url);
  await until(page, () => Boolean(window.__gjk));
  return page;
}

/** Asks the page until it says yes: waitForFunction would evaluate a string, which the page's own policy forbids. */
export async function until(page, predicate, milliseconds = 30000) {
  const end = Date.now() + milliseconds;
  while (!(await page.evaluate(predicate))) {
    if (Date.now() > end) throw new Error(`never came true: ${predicate}`);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
}

/** The colour that a screenshot shows at points, each the mean of 3 by 3 pixels. */
export async function colorsAt(context, page, points) {
  await page.evaluate(() => window.__gjk.drawNow());
  const picture = (await page.screenshot()).toString('base64');
  const blank = await context.newPage();
  const colors = await blank.evaluate(async ([base64, places]) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
    const context2d = canvas.getContext('2d');
    context2d.drawImage(image, 0, 0);
    return places.map(({ x, y }) => {
      const { data } = context2d.getImageData(Math.round(x) - 1, Math.round(y) - 1, 3, 3);
      return [0, 1, 2].map((channel) => {
        let sum = 0;
        for (let i = channel; i < 36; i += 4) sum += data[i];
        return sum / 9;
      });
    });
  }, [picture, points]);
  await blank.close();
  return colors;
}

export const isRed = ([r, g, b]) => r > 1.6 * g && r > 1.6 * b;
export const isGreen = ([r, g, b]) => g > 1.3 * r && g > 1.15 * b;
