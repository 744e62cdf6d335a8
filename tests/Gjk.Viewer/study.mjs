// A scripted observer does studies in Chromium, with keys at 1280 x 800 and with touch at 390 x 844. What the page
// stored is fitted by the demo, which asks the library again and refuses a distance that differs in one bit. Unless
// GJK_LONG is 1, each gap is judged once only, and a page is drawn with a quarter of its pixels, at which nobody looks.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { PATIENCE_MS } from './browser.mjs';
import { openPage, startBrowser, until } from './play-browser.mjs';
import { check, finish, isLong } from './check.mjs';
import { demo } from './play-demo.mjs';
import { Observer, ready } from './study-observer.mjs';

const folder = process.argv[2];

if (existsSync(join(folder, 'study.js'))) {
  await check('study: the bundle study.js is what its sources make', () => {
    assert.ok(readFileSync(join(folder, 'study.js')).equals(readFileSync('../../src/Gjk.Demo/viewer/dist/study.js')));
  });
}

const { browser } = await startBrowser();

const study = isLong ? 'study' : 'study-short', deviceScaleFactor = isLong ? 1 : 0.5;
const screens = [['wide', { width: 1280, height: 800 }, false], ['phone', { width: 390, height: 844 }, true]];
await Promise.all(screens.map(async ([name, viewport, hasTouch]) => {
  const context = await browser.newContext({ viewport, deviceScaleFactor, hasTouch, acceptDownloads: true });
  context.setDefaultTimeout(PATIENCE_MS);
  await context.setOffline(true);
  await check(`study: ${name}: a study, closed half-way, loses nothing`, () =>
    whole(context, { name, isTouch: hasTouch, width: viewport.width }));
  await context.close();
}));
await check('study: a view that turns, with a texture, is drawn, and both change the picture', looks);
await check('study: the blind spot gives the distance that the dot and the card say', distances);
await check('study: the button for the full screen fills it', fullScreen);
await browser.close();
finish();

async function opened(page = join(folder, 'study-looks.html')) {
  const context = await browser.newContext({ viewport: { width: 1000, height: 700 }, deviceScaleFactor });
  context.setDefaultTimeout(PATIENCE_MS);
  const opened = await openPage(context, page);
  await ready(opened);
  return new Observer({ page: opened, isTouch: false, keep: async () => {} });
}

/** The plan's two views differ in texture alone, and the second one turns. */
async function looks() {
  const observer = await opened(), { page } = observer, pictures = new Map();
  await observer.begin('looks');
  while (pictures.size < 2) {
    const state = await observer.state();
    if (state.screen) {
      await observer.press('Start');
      continue;
    }
    const { name, texture, turning } = await page.evaluate(() => {
      const { view } = window.__gjk.app, mesh = view.bodies[0].children[0];
      return { name: `${view.isTurning}`, texture: Boolean(mesh.material.map), turning: view.isTurning };
    });
    assert.equal(texture, turning);
    const shot = () => page.locator('.canvas canvas').first().screenshot();
    const first = await shot();
    await page.waitForTimeout(150);
    const second = await shot();
    assert.equal(first.equals(second), !turning, `turning: ${turning}`);
    writeFileSync(join(folder, `study-looks-${name}.png`), first);
    pictures.set(name, first);
    await observer.adjust(state);
  }
  assert.deepEqual(page.complaints, []);
  await page.context().close();
}

async function distances() {
  const observer = await opened(), { page } = observer;
  await observer.reachCalibration();
  await page.locator('#card').fill('4');
  await observer.press('Measure the distance by the blind spot');
  const gone = [];
  for (let run = 0; run < 5; run++) {
    await observer.press('Run');
    await page.waitForTimeout(1000 + 60 * run);
    gone.push(await page.evaluate(() => {
      const [dot, right] = ['.dot', '.square'].map((name) => document.querySelector(name).getBoundingClientRect().right);
      document.querySelector('.blind ~ .go').click();
      return right - dot;
    }));
  }
  const measured = Number(await page.locator('#distance').inputValue());
  const middle = gone.sort((a, b) => a - b)[2] / 4 / Math.tan((13.5 * Math.PI) / 180);
  // The dot is where its last frame has it: at 30 mm a second a frame of 100 ms is 12 mm of distance.
  assert.ok(Math.abs(measured - middle) < 15, `${measured} for ${middle}`);
  await observer.press('Next');
  const { viewingDistance, viewingDistanceBy } = await page.evaluate(() => window.__gjk.store.state);
  assert.deepEqual([viewingDistance, viewingDistanceBy], [measured, 'blind spot']);
  await page.context().close();
}

async function fullScreen() {
  const observer = await opened(), { page } = observer;
  await observer.press('Full screen');
  await until(page, () => document.fullscreenElement === document.documentElement);
  await page.context().close();
}

async function whole(context, { name, isTouch, width }) {
  const plan = JSON.parse(readFileSync(join(folder, `${study}-plan.json`)));
  const begun = async () => {
    const page = await openPage(context, join(folder, `${study}.html`));
    await ready(page);
    const keep = async (screen) => {
      await page.screenshot({ path: join(folder, `study-${name}-${screen}.png`) });
      assert.deepEqual(await faultsOf(page, width), [], screen);
    };
    return new Observer({ page, isTouch, keep });
  };
  const first = await begun();
  await first.begin('scripted');
  const half = await first.answer(40);
  const before = await first.page.evaluate(() => window.__gjk.store.csv());
  assert.deepEqual(first.page.complaints, []);
  await first.page.close();

  const second = await begun();
  assert.equal((await second.state()).screen, 'Welcome back');
  assert.equal(await second.page.evaluate(() => window.__gjk.store.csv()), before);
  const { stored } = await second.answer();
  await second.see('end');
  const expected = trialsOf(plan);
  assert.ok(half.stored >= 40 && half.stored < expected, `${half.stored}`);
  assert.equal(stored, expected);
  const files = await saved(second, name);
  assert.ok(files.csv.startsWith(before), 'the first half is what it was');
  assertRows(files);
  assert.deepEqual(second.page.complaints, []);
  for (const kind of ['csv', 'json']) {
    const figures = demo('study', 'fit', join(folder, `study-${name}.${kind}`));
    // Of one answer to each gap no threshold need follow.
    assert.match(figures, isLong ? /constant,box-box,all,pse,/ : /constant,/);
  }
}

/** Nothing is cut off, and every control is large enough for a finger. */
function faultsOf(page, width) {
  return page.evaluate((wide) => {
    const found = document.documentElement.scrollWidth > wide ? ['the page scrolls sideways'] : [];
    for (const each of document.querySelectorAll('button, select, input')) {
      const box = (each.closest('label') ?? each).getBoundingClientRect();
      if (box.height < 44 || box.width < 44) found.push(`${each.outerHTML} is ${box.width} x ${box.height}`);
      if (box.left < 0 || box.right > wide) found.push(`${each.outerHTML} is cut off`);
    }
    return found;
  }, width);
}

async function saved({ page }, name) {
  const downloads = [];
  page.on('download', (download) => downloads.push(download));
  await page.locator('button', { hasText: /^Save the data$/ }).click();
  await until({ evaluate: () => downloads.length >= 2 }, () => true);
  const files = {};
  for (const download of downloads) {
    const kind = download.suggestedFilename().split('.').at(-1);
    files[kind] = readFileSync(await download.path(), 'utf8');
    writeFileSync(join(folder, `study-${name}.${kind}`), files[kind]);
  }
  return files;
}

function trialsOf({ pairs, views, adjustment, constant, mismatch, practice, catch: caught }) {
  const each = adjustment.repeats * adjustment.starts.length + constant.repeats * constant.gaps.length
    + mismatch.repeats * mismatch.colliders.length;
  return pairs.length * views.length * each + caught.trials + 3 * practice;
}

/** Both files say the same; gaps are met to the last bit; the answers follow the gaps; the screen is measured. */
function assertRows({ csv, json }) {
  const [head, ...lines] = csv.trim().split('\n').map((line) => line.split(','));
  const rows = lines.map((line) => Object.fromEntries(head.map((column, i) => [column, line[i]])));
  const { trials, person, pixelsPerMillimetre } = JSON.parse(json);
  assert.equal(person, 'scripted');
  assert.equal(pixelsPerMillimetre, 4);
  assert.deepEqual(trials.map((row) => [row.trial, row.distance, row.record]),
    rows.map((row) => [Number(row.trial), Number(row.distance), row.record]));
  assert.deepEqual(rows.map(({ trial }) => Number(trial)), rows.map((_, i) => i + 1));
  const constant = rows.filter(({ task }) => task === 'constant');
  for (const { gap, distance } of constant) assert.equal(Number(distance), Math.fround(Number(gap)));
  for (const { distance, pixels, arcminutes } of rows) {
    const minutes = Math.atan(Number(pixels) / 4 / 570) * (180 * 60) / Math.PI;
    assert.ok(Math.abs(minutes - Number(arcminutes)) < 1e-9, `${pixels} pixels are ${arcminutes} minutes of arc`);
    assert.equal(Math.sign(Number(pixels)), Math.sign(Number(distance)));
  }
  for (const kind of ['trial', 'practice', 'catch']) assert.ok(rows.some((row) => row.kind === kind), kind);
  const adjusted = rows.filter(({ task, kind }) => task === 'adjustment' && kind === 'trial');
  assert.ok(adjusted.every(({ start }, i) => Number(start) > 0 === (i % 2 === 0)), 'the starts take turns');
  assert.ok(adjusted.some(({ start, distance }) => Number(start) !== Number(distance)));
}
