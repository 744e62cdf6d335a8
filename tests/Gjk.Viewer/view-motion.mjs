// The page of view with scenes that move, and with one of two thousand objects.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { colorsAt, eventually, hover, until } from './browser.mjs';
import { check } from './check.mjs';
import { readCsv } from './csv.mjs';
import { button, counts, rows, text } from './read.mjs';

/** Far more than it takes on a busy machine. */
const MANY_SECONDS = 150;

export async function checkMotion(tools) {
  await checkFrames(tools);
  await checkSweep(tools);
  await checkMany(tools);
}

async function checkFrames({ folder, open, keep }) {
  const page = await open('moving');
  const answers = readCsv(join(folder, 'moving.csv'));
  await check('moving: hovering over a line shows distance, normal and iterations as query has them', async () => {
    const pair = answers.findIndex((row) => row.a === 3 && row.b === 4);
    const { distance, nx, ny, nz, iterations } = answers[pair];
    const middle = () => page.evaluate((p) => window.__gjk.lineAt(p, 0.5), pair);
    await hover(page, middle, (tip) => {
      const entries = [...tip.matchAll(/(distance|normal|iterations)\s+(.*)/g)];
      const shown = Object.fromEntries(entries.map((m) => [m[1], m[2].replaceAll('−', '-')]));
      assert.match(tip, /^cylinder – cone/);
      assert.ok(Math.abs(Number(shown.distance) - distance) <= 1e-5 * distance, `${shown.distance} for ${distance}`);
      const rounded = [nx, ny, nz].map((n) => Number((Math.abs(n) < 5e-5 ? 0 : n).toFixed(4)));
      assert.deepEqual(shown.normal.match(/-?[\d.]+/g).map(Number), rounded);
      assert.equal(Number(shown.iterations), iterations);
    });
    await keep(page, 'moving-hover');
  });

  await check('moving: the slider replays the frames, and what meets turns red', async () => {
    const show = async (frame) => {
      await page.locator('input[type=range]').fill(String(frame));
      return eventually(async () => {
        const all = await counts(page);
        assert.equal(all.frame, frame);
        const colors = await page.evaluate(() => [0, 1].map((o) => window.__gjk.colorOf(o)));
        return { ...all, colors, at: await page.evaluate(() => window.__gjk.positionOf(1)) };
      });
    };
    const first = await show(0),
      before = await show(7),
      met = await show(8);
    assert.deepEqual([first.overlapping, before.overlapping, met.overlapping], [0, 0, 1]);
    assert.deepEqual([first.contacts, before.contacts, met.contacts], [0, 0, 1]);
    assert.ok(met.at.x < first.at.x - 50);
    assert.deepEqual(first.colors, ['#38a873', '#38a873']);
    assert.deepEqual(met.colors, ['#e5484d', '#e5484d']);
    assert.match(await text(page, '.summary'), /1 intersecting/);
    assert.match((await rows(page))[0][2], /^depth /);
    await keep(page, 'moving-met');
    await button(page, 'play').click();
    await until(page, () => window.__gjk.counts().frame !== 8);
    await button(page, 'pause').click();
  });
  await check('moving: no error, nothing fetched', async () => assert.deepEqual(page.complaints, []));
  await page.close();
}

async function checkSweep({ open, keep }) {
  const page = await open('sweep');
  await check('sweep: the list says when the pairs meet, and what turns is not cast', async () => {
    const found = Object.fromEntries((await rows(page)).map(([a, b, , impact]) => [`${a} ${b}`, impact]));
    assert.equal(found['crate ball'], '0.5');
    assert.equal(found['crate passer'], 'miss');
    assert.equal(found['crate inside'], 'at start');
    assert.equal(found['crate turner'], '');
    const { paths, impacts } = await counts(page);
    assert.deepEqual([paths, impacts], [4, 1]);
  });
  await check('sweep: the impact is on the screen, with its facts, and a button hides it', async () => {
    const place = () =>
      page.evaluate(() => {
        const { a, b } = window.__gjk.model;
        return window.__gjk.impactAt(a.findIndex((first, i) => first === 0 && b[i] === 1));
      });
    await eventually(async () => {
      const [[r, g, b]] = await colorsAt(page, [await place()]);
      assert.ok(r > 1.2 * g && g > 1.2 * b, `the impact is ${[r, g, b]}`);
    });
    const at = 'impact at\\s+\\(−1, 0, 0\\)',
      normal = 'impact normal\\s+\\(−1\\.0000, 0\\.0000, 0\\.0000\\)';
    const facts = new RegExp(`impact after\\s+0\\.5 of a frame\\s+${at}\\s+${normal}`);
    await hover(page, place, (tip) => assert.match(tip, facts));
    await keep(page, 'sweep');
    await button(page, 'hidden').click();
    await eventually(async () => {
      const { paths, impacts } = await counts(page);
      assert.deepEqual([paths, impacts], [0, 0]);
    });
    await button(page, 'shown').click();
  });
  await check('sweep: sorted by impact; a selected pair shows only its own', async () => {
    await page.locator('.head button', { hasText: 'impact' }).click();
    await eventually(async () => {
      const impacts = (await rows(page)).map((cells) => cells[3]);
      assert.deepEqual(impacts.slice(0, 2), ['at start', '0.5']);
    });
    await page.locator('.rows .row').nth(1).click();
    await eventually(async () => {
      const shown = await counts(page);
      assert.deepEqual([shown.paths, shown.impacts], [1, 1]);
    });
    assert.deepEqual(page.complaints, []);
  });
  await page.close();
}

async function checkMany({ folder, open, keep }) {
  await check('many: two thousand objects open, select and sort in seconds', async () => {
    // Of two million rows, counted as text: as objects they take gigabytes.
    const expected = readFileSync(join(folder, 'many.csv'), 'latin1').split(',true,').length - 1;
    const start = Date.now();
    const page = await open('many');
    const { objects, overlapping } = await counts(page);
    assert.deepEqual([objects, overlapping], [2000, expected]);
    assert.match(await text(page, '.summary'), /^2000 objects, 1999000 pairs/);
    const row = page.locator('.rows .row').nth(3);
    const pair = Number(await row.getAttribute('data-pair'));
    await row.click();
    await eventually(async () => assert.equal(await page.evaluate(() => window.__gjk.selected()), pair));
    await page.locator('.head button', { hasText: 'iter.' }).click();
    await keep(page, 'many');
    assert.deepEqual(page.complaints, []);
    const seconds = (Date.now() - start) / 1000;
    console.log(`many: ${seconds.toFixed(1)} s`);
    assert.ok(seconds < MANY_SECONDS, `${seconds} s`);
    await page.close();
  });
}
