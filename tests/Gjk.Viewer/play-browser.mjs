// A page of the playground in headless Chromium. Everything that the page complains about or fetches is recorded.
import { chromium } from 'playwright-core';
import { pathToFileURL } from 'node:url';
import { FLAGS } from './browser.mjs';

/** How long a page may take to do what a check waits for, and the pause before it is asked again. */
const PATIENCE = 60_000, PAUSE = 20;

export async function startBrowser() {
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, headless: true, args: FLAGS });
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  context.setDefaultTimeout(PATIENCE);
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

/** Asks the page until it says yes: waitForFunction would evaluate a string, which the page's own policy forbids. */
export async function until(page, predicate) {
  const end = Date.now() + PATIENCE;
  while (!(await page.evaluate(predicate))) {
    if (Date.now() > end) throw new Error(`never came true: ${predicate}`);
    await new Promise((resolve) => { setTimeout(resolve, PAUSE); });
  }
}
