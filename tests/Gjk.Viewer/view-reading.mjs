// What makes the page of view readable to everyone: stripes, themes, names, axes, coordinates, keys, fingers.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { PHONE, brightness, colorsAt, eventually, settled } from './browser.mjs';
import { check } from './check.mjs';
import { readCsv } from './csv.mjs';
import { button, counts, rows, text } from './read.mjs';

/** The least breadth and height of what a finger must hit, in CSS pixels. */
export const TARGET = 44;

/** A row of pixels long enough to cross two stripes. */
const ACROSS = Array.from({ length: 24 }, (_, i) => i - 12);

export async function checkViewReading(tools) {
  const page = await tools.open('cubes', LIGHT);
  await checkThemes(page);
  await checkStripes(page);
  await checkLabels(page);
  await checkKeys(page);
  await check('view: no error in either theme', async () => assert.deepEqual(page.complaints, []));
  await page.close();
  await checkCopy(tools);
  await checkFrameKeys(tools);
  await checkFingers(tools);
  await checkEmpty(tools);
}

const LIGHT = {
  viewport: { width: 1280, height: 800 },
  colorScheme: 'light',
  permissions: ['clipboard-read', 'clipboard-write'],
};

const selected = (page) => page.evaluate(() => window.__gjk.selected());
const backOf = async (page) => brightness((await colorsAt(page, [{ x: 20, y: 20 }]))[0]);

async function checkThemes(page) {
  await check('view: the theme follows the system, until the button or T chooses one', async () => {
    const is = (name, test) =>
      eventually(async () => {
        const back = await backOf(page);
        assert.ok(test(back), `${name}: ${back}`);
      });
    const isLight = () => is('light', (x) => x > 220),
      isDark = () => is('dark', (x) => x < 40);
    await isLight();
    await page.emulateMedia({ colorScheme: 'dark' });
    await isDark();
    await page.emulateMedia({ colorScheme: 'light' });
    await isLight();
    await button(page, 'theme').click();
    await isDark();
    await page.keyboard.press('t');
    await isLight();
    await page.emulateMedia({ colorScheme: 'dark' });
    await page.emulateMedia({ colorScheme: 'light' });
    await isLight();
  });
}

async function checkStripes(page) {
  await check('view: what intersects is striped, so its colour is not all that tells it', async () => {
    await button(page, 'none').click();
    const contrastOf = async (object) => {
      const { x, y } = await page.evaluate((o) => window.__gjk.positionOf(o), object);
      const row = (
        await colorsAt(
          page,
          ACROSS.map((aside) => ({ x: x + aside, y })),
          1,
        )
      ).map(brightness);
      return Math.min(...row) / Math.max(...row);
    };
    await eventually(async () => {
      for (const [object, isStriped] of [[11, true], [19, true], [1, false], [9, false]]) {
        const contrast = await contrastOf(object);
        assert.ok(isStriped ? contrast < 0.75 : contrast > 0.9, `${object}: ${contrast}`);
      }
    });
    await button(page, 'all').click();
  });
}

async function checkLabels(page) {
  const shown = () =>
    page.locator('.label').evaluateAll((all) =>
      all
        .filter((each) => each.style.visibility === 'visible')
        .map((each) => {
          const { left, top, right, bottom } = each.getBoundingClientRect();
          return { text: each.textContent, left, top, right, bottom };
        }),
    );
  await check('view: a button shows the names, and none lies on another', async () => {
    assert.deepEqual(await shown(), []);
    await button(page, 'names').click();
    await eventually(async () => {
      const labels = await shown();
      assert.ok(labels.length > 15, `${labels.length} names`);
      assert.ok(labels.every(({ text: name }) => /^Cube \(\d+\)$/.test(name)));
      assertApart(labels);
    });
    await page.keyboard.press('n');
    await eventually(async () => assert.deepEqual(await shown(), []));
  });
  await check('view: a button shows the ground and the axes, and says how far its lines are apart', async () => {
    assert.equal(await page.locator('.ground').isVisible(), false);
    await button(page, 'axes').click();
    await eventually(async () =>
      assert.deepEqual(
        (await shown()).map((each) => each.text),
        ['x', 'y', 'z'],
      ),
    );
    assert.match(await text(page, '.ground'), /^ground y = −?[\d.]+, lines (1|2|5|0\.5) apart$/);
    await page.keyboard.press('g');
    await eventually(async () => assert.deepEqual(await shown(), []));
  });
}

/** Asserts that no two boxes overlap. */
export function assertApart(labels) {
  labels.forEach((p, i) =>
    labels.slice(0, i).forEach((q) => {
      const overlap = p.left < q.right && q.left < p.right && p.top < q.bottom && q.top < p.bottom;
      assert.ok(!overlap, `${p.text} lies on ${q.text}`);
    }),
  );
}

async function checkKeys(page) {
  await check('view: keys select pairs, turn and zoom without a click into the picture', async () => {
    await page.reload();
    await eventually(() => settled(page));
    const order = await page.locator('.rows .row').evaluateAll((all) => all.map((row) => Number(row.dataset.pair)));
    for (const [key, at] of [
      ['ArrowDown', 0],
      ['ArrowDown', 1],
      ['ArrowUp', 0],
    ]) {
      await page.keyboard.press(key);
      await eventually(async () => assert.equal(await selected(page), order[at]));
    }
    await page.keyboard.press('Escape');
    await eventually(async () => assert.equal(await selected(page), -1));
    const where = () => page.evaluate(() => window.__gjk.positionOf(19));
    const first = await where();
    const moves = async (key) => {
      const before = await where();
      await page.keyboard.press(key);
      await eventually(async () => {
        const now = await where();
        assert.ok(Math.hypot(now.x - before.x, now.y - before.y) > 3, key);
      });
    };
    for (const key of ['ArrowLeft', 'Shift+ArrowUp', '+']) await moves(key);
    await page.keyboard.press('0');
    await eventually(async () => {
      const last = await where();
      assert.ok(Math.hypot(last.x - first.x, last.y - first.y) < 2);
    });
  });
}

async function checkCopy({ folder, open }) {
  const page = await open('moving', LIGHT);
  await check('view: the closest points are shown, and copied with the bits of query', async () => {
    const answers = readCsv(join(folder, 'moving.csv'));
    const row = page.locator('.rows .row').nth(8);
    const pair = Number(await row.getAttribute('data-pair'));
    await row.click();
    const { distance, ax, ay, az, bx, by, bz, nx, ny, nz } = answers[pair];
    const unsigned = (v) => v.map((x) => x + 0);
    await button(page, 'copy').click();
    await eventually(async () => assert.equal(await text(page, '.detail button'), 'copied'));
    const copied = (await page.evaluate(() => navigator.clipboard.readText())).split('\n');
    assert.equal(copied[0], await text(page, '.detail h2'));
    const read = copied.slice(1).map((line) => line.replace(/^\D+ /, '').split(', ').map(Number));
    assert.deepEqual(read, [[distance], [ax, ay, az], [bx, by, bz], [nx, ny, nz]].map(unsigned));
    const shown = (await text(page, '.detail')).replaceAll('−', '-');
    const [, x] = /on A\s+\(([-\d.e]+),/.exec(shown);
    assert.ok(Math.abs(Number(x) - ax) <= 1e-5 * Math.abs(ax), `${x} for ${ax}`);
  });
  await page.close();
}

async function checkFrameKeys({ open }) {
  const page = await open('moving');
  await check('view: arrow keys go through the frames, and space plays them', async () => {
    const at = (frame) => eventually(async () => assert.equal((await counts(page)).frame, frame));
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    await at(2);
    await page.keyboard.press('ArrowLeft');
    await at(1);
    await page.keyboard.press(' ');
    await eventually(async () => assert.ok((await counts(page)).frame > 2));
    await page.keyboard.press(' ');
    assert.equal(await button(page, 'play').count(), 1);
  });
  await page.close();
}

/** Asserts that everything to press is large enough for a finger. */
export async function assertTargets(page, selector) {
  const small = await page.locator(selector).evaluateAll((all, least) => {
    const seen = all.filter((each) => each.getClientRects().length > 0);
    const sizes = seen.map((each) => [each.textContent || each.type, each.getBoundingClientRect()]);
    return sizes
      .filter(([, box]) => box.width < least || box.height < least)
      .map(([name, box]) => `${name}: ${box.width} x ${box.height}`);
  }, TARGET);
  assert.deepEqual(small, []);
}

/** Asserts that the picture stays at the top of the screen when the page below it is scrolled to its end. */
export async function assertSticks(page) {
  await page.evaluate(() => window.scrollTo(0, document.documentElement.scrollHeight));
  const top = await page.locator('.stage').evaluate((each) => each.getBoundingClientRect().top);
  assert.ok(Math.abs(top) <= 1, `the picture begins at ${top}`);
}

async function checkFingers({ open }) {
  const page = await open('sweep', PHONE);
  await check('view: a finger can hit every button, row and slider of a phone', async () => {
    await page.locator('.rows .row').nth(1).tap();
    await eventually(async () => assert.match(await text(page, '.detail'), /copy[\s\S]*on A/));
    await assertTargets(page, 'button, input, .rows .row');
    const { left, right } = await page
      .locator('.rows .row')
      .first()
      .evaluate((row) => row.getBoundingClientRect());
    assert.ok(left >= 0 && right <= 390, `${left} to ${right}`);
    await assertSticks(page);
    assert.deepEqual(page.complaints, []);
  });
  await page.close();
}

async function checkEmpty({ open }) {
  await check('view: an empty scene says so, and one object is one object', async () => {
    const empty = await open('empty');
    assert.match(await text(empty, '.summary'), /^0 objects, 0 pairs, 0 intersecting$/);
    assert.match(await text(empty, '.canvas .message'), /no objects/);
    assert.match(await text(empty, '.rows'), /no pairs/);
    assert.deepEqual(empty.complaints, []);
    await empty.close();
    const two = await open('two');
    assert.match(await text(two, '.summary'), /^2 objects, 1 pair, 0 intersecting$/);
    assert.equal((await rows(two)).length, 1);
    await two.close();
  });
}
