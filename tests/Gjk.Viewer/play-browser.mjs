// A page of the playground in headless Chromium. Everything that the page complains about or fetches is recorded.
import { pathToFileURL } from 'node:url';
import { PATIENCE_MS, startBrowser as start, until } from './browser.mjs';

export { until };

export async function startBrowser() {
  const browser = await start();
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  context.setDefaultTimeout(PATIENCE_MS);
  await context.setOffline(true);
  return { browser, context };
}

/** Opens a page from the disk, with the end of its address, and waits until the library has started. */
export async function openPage(context, file, hash = '') {
  const page = await context.newPage();
  const url = pathToFileURL(file).href;
  page.complaints = [];
  page.on('console', (message) => { if (message.type() === 'error') page.complaints.push(message.text()); });
  page.on('pageerror', (error) => page.complaints.push(String(error)));
  page.on('request', (request) => {
    if (request.url() !== url && !request.url().startsWith('data:')) page.complaints.push(`fetched ${request.url()}`);
  });
  await page.goto(url + hash);
  await until(page, () => Boolean(window.__gjk));
  return page;
}
