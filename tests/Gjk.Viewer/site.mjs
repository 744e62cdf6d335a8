// Opens every page of the site, wide and narrow, light and dark: no console error, no missing file, no dead link, nothing
// cut off, nothing illegible.
import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import { readFileSync, readdirSync, statSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { extname, join, resolve } from 'node:path';
import { PATIENCE_MS, startBrowser } from './browser.mjs';
import { check, finish } from './check.mjs';
import { LOOKS, faultsOfLook } from './looks.mjs';

const [site, pictures] = process.argv.slice(2).map((path) => resolve(path));
const SIZES = { wide: { width: 1280, height: 800 }, narrow: { width: 390, height: 844 } };
/** How wide a page shows a picture, in both sizes. */
const PICTURES = [624, 342];
const TYPES = {
  '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.json': 'application/json',
  '.woff2': 'font/woff2', '.png': 'image/png',
};
// Pages of which a picture is kept, to be looked at.
const KEPT = ['index', 'book/01-the-origin', 'book/02-the-simplex', 'book/looping', 'queries', 'api/queries', 'performance'];

// A page whose figures are started: each must be as tall as it says.
const WITH_FIGURES = 'book/02-the-simplex';

const server = createServer((request, response) => {
  const path = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
  const file = join(site, path.endsWith('/') ? path + 'index.html' : path);
  const found = [file, file + '.html'].find((f) => f.startsWith(site) && isFile(f));
  response.writeHead(found ? 200 : 404, {
    'Content-Type': TYPES[extname(found ?? '')] ?? 'application/octet-stream',
    'Cache-Control': 'max-age=3600',
  });
  response.end(found ? readFileSync(found) : 'not found');
});
await new Promise((done) => server.listen(0, '127.0.0.1', done));
const origin = `http://127.0.0.1:${server.address().port}`;

const pages = files(site).filter((file) => file.endsWith('.html') && !/(^|\/)(404|play)\.html$/.test(file));
const browser = await startBrowser();
const links = new Map();
const context = await browser.newContext({ viewport: SIZES.wide });
context.setDefaultTimeout(PATIENCE_MS);
await check('every picture is legible', () => lookAtPictures(context));
// Each core has a tab, which opens one page after another: a new tab is a new process, and starts with nothing compiled.
const waiting = [...pages];
await Promise.all(Array.from({ length: availableParallelism() }, async () => {
  const tab = await context.newPage();
  while (waiting.length) {
    const page = waiting.shift();
    await check(`${page} is whole, wide and narrow`, () => look(tab, page));
  }
  await tab.close();
}));

await check('no link is dead', async () => {
  const dead = [];
  for (const [link, from] of links) {
    const [path, anchor] = link.split('#');
    const response = await fetch(path);
    if (!response.ok) dead.push(`${link} of ${from}`);
    else if (anchor && !(await response.text()).includes(`id="${decodeURIComponent(anchor)}"`)) dead.push(`${link} of ${from}`);
  }
  assert.deepEqual(dead, []);
  assert.ok(links.size > 50, `only ${links.size} links were found`);
});

await check('the search finds a page', async () => {
  const page = await context.newPage();
  await page.setViewportSize(SIZES.wide);
  await page.goto(origin);
  await page.locator('#local-search button').click();
  await page.locator('.search-input').fill('epsilon');
  await page.locator('.results a[href*="epsilon"]').first().waitFor();
});
await browser.close();
server.close();
finish();

async function look(page, name) {
  const complaints = [];
  page.on('console', (message) => { if (message.type() === 'error') complaints.push(message.text()); });
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('response', (response) => { if (!response.ok()) complaints.push(`${response.status()} ${response.url()}`); });
  page.on('request', (request) => { if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(origin)) complaints.push(`fetched ${request.url()}`); });
  await page.setViewportSize(SIZES.wide);
  await page.emulateMedia({ colorScheme: 'light' });
  await page.goto(`${origin}/${name.replace(/\.html$/, '')}`.replace(/index$/, ''), { waitUntil: 'load' });
  await page.locator('.VPDoc, .VPHome').first().waitFor();
  // What slides or fades away when the size changes is away at once.
  await page.addStyleTag({ content: '* { transition: none !important }' });
  for (const href of await page.locator('a[href]').evaluateAll((all) => all.map((a) => a.href))) {
    if (href.startsWith(origin)) links.set(href, name);
  }
  const plain = name.replace(/\.html$/, '');
  for (const [size, viewport] of Object.entries(SIZES)) {
    await page.setViewportSize(viewport);
    for (const fault of await page.evaluate(cutOff)) complaints.push(`${size}: ${fault}`);
    for (const look of LOOKS.filter(({ width }) => width === viewport.width)) {
      await page.emulateMedia({ colorScheme: look.theme });
      for (const fault of await page.evaluate(faultsOfLook)) complaints.push(`${size}, ${look.theme}: ${fault}`);
    }
    if (name.startsWith(WITH_FIGURES)) await waitForFigures(page);
    if (KEPT.includes(plain)) await page.screenshot({ path: join(pictures, `${plain.replaceAll('/', '-')}-${size}.png`) });
  }
  for (const event of ['console', 'pageerror', 'response', 'request']) page.removeAllListeners(event);
  assert.deepEqual(complaints, []);
}

/** Looks at the drawings of the book as wide as its pages show them. */
async function lookAtPictures(context) {
  const page = await context.newPage(), faults = [];
  const pictures = ['.', 'figures'].flatMap((folder) => readdirSync(join(site, '..', folder)).map((file) => join(folder, file)))
    .filter((file) => file.endsWith('.svg'));
  assert.ok(pictures.length > 10, `${pictures.length} pictures`);
  for (const width of PICTURES) {
    await page.setViewportSize({ width, height: 800 });
    for (const picture of pictures) {
      const drawing = readFileSync(join(site, '..', picture), 'utf8');
      await page.setContent(`<style>body { margin: 0 } svg { width: 100%; height: auto }</style>${drawing}`);
      for (const colorScheme of ['light', 'dark']) {
        await page.emulateMedia({ colorScheme });
        for (const fault of await page.evaluate(faultsOfLook)) faults.push(`${picture}, ${width}, ${colorScheme}: ${fault}`);
      }
    }
  }
  await page.close();
  assert.deepEqual(faults, []);
}

function files(folder) {
  return readdirSync(folder, { recursive: true }).filter((file) => isFile(join(folder, file)));
}

/** What of a page does not fit its window; it runs in the page. */
function cutOff() {
  const width = document.documentElement.clientWidth;
  const wide = document.documentElement.scrollWidth > width + 1 ? [`the page is ${document.documentElement.scrollWidth} wide`] : [];
  for (const element of document.querySelectorAll('.vp-doc :is(pre, table, [class*=language-])'))
    if (element.scrollWidth > element.clientWidth + 1 && element.clientWidth > 0 && !scrolls(element))
      wide.push(`${element.tagName} of ${element.scrollWidth} in ${element.clientWidth}: ${element.textContent.slice(0, 40)}`);
  for (const element of document.querySelectorAll('.vp-doc :is(h1, h2, h3, p, li, img, figcaption)')) {
    const right = element.getBoundingClientRect().right;
    if (right > width + 1) wide.push(element.textContent.slice(0, 60));
  }
  // A cell that is narrower than this breaks words letter by letter.
  for (const cell of document.querySelectorAll('.vp-doc :is(th, td)')) {
    const longest = Math.max(...cell.textContent.split(/\s/).map((word) => word.length));
    if (cell.clientWidth > 0 && cell.clientWidth < 40 && longest > 4)
      wide.push(`a cell of ${cell.clientWidth}: ${cell.textContent.slice(0, 40)}`);
  }
  // Where there is room, a word in a cell stays in one piece.
  for (const name of document.querySelectorAll('.vp-doc table:not(:has(th:nth-child(4))) td code'))
    if (width > 640 && !/[\s{(/_.-]/.test(name.textContent) && name.getClientRects().length > 1) wide.push(`${name.textContent} is broken`);
  // A break before a component at the start of a line is lost, and with it the space.
  for (const part of document.querySelectorAll('.vp-doc .part'))
    if (/\w$/.test(part.previousSibling?.textContent ?? '')) wide.push(`no space before ${part.textContent}`);
  // A table of numbers scrolls on a phone; the names of its rows stay.
  function scrolls(element) {
    const name = element.querySelector('td');
    return element.matches('table.numbers') && getComputedStyle(element).overflowX === 'auto'
      && getComputedStyle(name).position === 'sticky';
  }
  const images = [...document.images].filter((image) => image.complete && image.naturalWidth === 0).map((image) => image.src);
  return [...wide, ...images];
}

/** Waits until the figures of a page have started and nothing of them is cut off. */
async function waitForFigures(page) {
  const frames = page.locator('figure.plane iframe');
  const count = await frames.count();
  assert.ok(count > 1, `${count} figures`);
  for (let i = 0; i < count; i++) {
    await frames.nth(i).scrollIntoViewIfNeeded();
    await page.waitForFunction((at) => {
      const frame = document.querySelectorAll('figure.plane iframe')[at], { body } = frame.contentDocument;
      const isStarted = Boolean(frame.contentWindow.__gjk);
      return isStarted && body.scrollHeight <= frame.clientHeight && body.scrollHeight > frame.clientHeight - 30;
    }, i);
  }
}

function isFile(path) {
  try {
    return statSync(path).isFile();
  } catch {
    return false;
  }
}
