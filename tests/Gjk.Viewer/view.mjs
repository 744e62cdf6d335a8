// The page of view with the built-in scenes: counts, colours, list, pointer.
import assert from 'node:assert/strict';
import { colorsAt, eventually, hover, isGreen, isRed, settled } from './browser.mjs';
import { check } from './check.mjs';
import { button, counts, rows, text } from './read.mjs';

/** The side of the square whose mean colour is taken: it spans a stripe and the gap beside it. */
const STRIPES = 9;

export async function checkView(tools) {
  const cubes = await builtIn(tools, 'cubes', [11, 19], [1, 9], 19);
  const spheres = await builtIn(tools, 'spheres', [11, 19], [1, 9], 18);
  await spheres.close();
  await checkList(tools, cubes);
  await checkPointer(tools, cubes);
  await checkCamera(cubes);
  await cubes.close();
}

async function builtIn({ open, keep }, name, intersecting, free, contacts) {
  const page = await open(name);
  await check(`${name}: the counts are the report's`, async () => {
    const of = { objects: 20, pairs: 190, frames: 1, frame: 0, overlapping: 5 };
    const marks = { arrows: 5, contacts, paths: 0, impacts: 0 };
    const { lines, ...rest } = await counts(page);
    assert.deepEqual(rest, { ...of, ...marks });
    assert.ok(lines > 0 && lines <= of.objects, `${lines} lines, where each object has one nearest`);
    await button(page, 'all').click();
    assert.equal((await counts(page)).lines, 185);
    assert.match(await text(page, '.summary'), /^20 objects, 190 pairs, 5 intersecting$/);
    const { objects, pairs, overlapping } = await page.evaluate(() => ({ ...document.body.dataset }));
    assert.deepEqual([objects, pairs, overlapping], ['20', '190', '5']);
  });
  await check(`${name}: what intersects is red on the screen, and the rest green`, async () => {
    await button(page, 'none').click();
    await eventually(async () => {
      const asked = [...intersecting, ...free];
      const places = await page.evaluate((objects) => objects.map((o) => window.__gjk.positionOf(o)), asked);
      const colors = await colorsAt(page, places, STRIPES);
      intersecting.forEach((object, i) => assert.ok(isRed(colors[i]), `object ${object} is ${colors[i]}`));
      free.forEach((object, i) => {
        const color = colors[intersecting.length + i];
        assert.ok(isGreen(color), `object ${object} is ${color}`);
      });
      const shown = await counts(page);
      assert.deepEqual([shown.lines, shown.arrows, shown.contacts], [0, 0, 0]);
    });
    await button(page, 'all').click();
  });
  await keep(page, name);
  await check(`${name}: no error, nothing fetched`, async () => assert.deepEqual(page.complaints, []));
  return page;
}

async function checkList({ keep }, page) {
  await check('the list is sorted by distance, and turns round', async () => {
    const distances = async () => (await rows(page)).map((cells) => Number(cells[2].replace('depth ', '-')));
    const rising = await distances();
    assert.ok(rising.length > 10);
    assert.deepEqual(
      rising,
      [...rising].sort((x, y) => x - y),
    );
    assert.equal(rising.filter((d) => d < 0).length, 5);
    await page.locator('.head button', { hasText: 'distance' }).click();
    await eventually(async () => {
      const falling = await distances();
      assert.deepEqual(
        falling,
        [...falling].sort((x, y) => y - x),
      );
      assert.ok(falling[0] > rising.at(-1));
    });
    await page.locator('.head button', { hasText: 'distance' }).click();
  });

  await check('a row selects its pair in the view', async () => {
    const row = page.locator('.rows .row').nth(6);
    const pair = Number(await row.getAttribute('data-pair'));
    await row.click();
    await eventually(async () => {
      assert.equal(await page.evaluate(() => window.__gjk.selected()), pair);
      assert.match(
        await text(page, '.detail'),
        /distance\s+0\.\d+\s+normal\s+\(.*\)\s+on A\s+\(.*\)\s+on B\s+\(.*\)\s+iterations\s+\d+/,
      );
    });
    await keep(page, 'cubes-selected');
    await page.locator('.rows').press('Escape');
    await eventually(async () => assert.equal(await page.evaluate(() => window.__gjk.selected()), -1));
  });
}

async function checkPointer({ keep }, page) {
  const row = page.locator('.rows .row').first();
  const pair = Number(await row.getAttribute('data-pair'));
  const along = (share) => page.evaluate(([p, s]) => window.__gjk.lineAt(p, s), [pair, share]);

  await check('hovering over a way out shows the depth, and the arrow is on the screen', async () => {
    const shown = await row.locator('span').nth(2).innerText();
    assert.match(shown, /^depth 0\.\d{3,6}$/);
    await settled(page);
    const [from, to] = [await along(0), await along(1)];
    assert.ok(Math.hypot(to.x - from.x, to.y - from.y) > 15, JSON.stringify([from, to]));
    await eventually(async () => {
      const [[r, g, b]] = await colorsAt(page, [await along(0.75)]);
      assert.ok(b > 1.2 * r && b > g, `the arrow is ${[r, g, b]}`);
    });
    await hover(
      page,
      () => along(0.5),
      (tip) => {
        const names = 'Cube \\(\\d+\\) – Cube \\(\\d+\\)',
          way = 'depth\\s+0\\.\\d+\\s+way out\\s+\\(.*\\)';
        const rest = 'contact points\\s+4\\s+gaps\\s+.*\\s+iterations\\s+\\d+';
        assert.match(tip, new RegExp(`^${names}\\s+${way}\\s+${rest}`));
        assert.ok(tip.replace(/\s+/g, ' ').includes(shown), tip);
      },
    );
    await keep(page, 'cubes-hover');
    const body = () => page.evaluate((p) => window.__gjk.positionOf(window.__gjk.model.a[p]), pair);
    await hover(page, body, (tip) => assert.match(tip, /intersects Cube \(\d+\) \(depth 0\.\d+\)/));
  });

  await check('the contact points are on the screen, and hovering over one shows its pair', async () => {
    const placesOf = () =>
      page.evaluate((p) => window.__gjk.model.contacts(p).map((_, i) => window.__gjk.contactAt(p, i)), pair);
    const seen = await eventually(async () => {
      const places = await placesOf();
      assert.equal(places.length, 4);
      const colors = await colorsAt(page, places);
      const found = colors.findIndex(([r, g, b]) => b > 1.2 * g && r > 1.2 * g && b > 0.9 * r);
      assert.ok(found >= 0, `the points are ${JSON.stringify(colors)}`);
      return found;
    });
    const names = await row.locator('span').allInnerTexts();
    const begin = `${names[0]} – ${names[1]}`;
    await hover(
      page,
      async () => (await placesOf())[seen],
      (tip) => assert.ok(tip.startsWith(begin), tip),
    );
  });

  await check('a click on a body lists its pairs', async () => {
    await button(page, 'none').click();
    const at = await page.evaluate(() => window.__gjk.positionOf(9));
    await page.mouse.click(at.x, at.y);
    await eventually(async () => {
      const names = await rows(page);
      const name = await text(page, '.chip strong');
      assert.ok(names.length > 10);
      assert.equal(await page.locator('.rows').evaluate((list) => Math.round(list.scrollHeight / 27)), 19);
      assert.ok(
        names.every(([a, b]) => a === name || b === name),
        name,
      );
    });
    await button(page, 'show all').click();
  });
}

async function checkCamera(page) {
  await check('dragging turns the view, the wheel zooms, reset brings it back', async () => {
    const where = async () => {
      await settled(page);
      return page.evaluate(() => [0, 19].map((o) => window.__gjk.positionOf(o)));
    };
    const span = ([a, b]) => Math.hypot(a.x - b.x, a.y - b.y);
    const moved = (p, q) => Math.hypot(p[0].x - q[0].x, p[0].y - q[0].y);
    const first = await where();
    await page.mouse.move(450, 60);
    await page.mouse.down();
    await page.mouse.move(610, 110, { steps: 6 });
    await page.mouse.up();
    const turned = await eventually(async () => {
      const now = await where();
      assert.ok(moved(now, first) > 30);
      return now;
    });
    await page.mouse.wheel(0, -600);
    await eventually(async () => assert.ok(span(await where()) > 1.1 * span(turned)));
    await button(page, 'reset view').click();
    await eventually(async () => {
      const last = await where();
      assert.ok(moved(last, first) < 2, JSON.stringify([first[0], last[0]]));
    });
  });
}
