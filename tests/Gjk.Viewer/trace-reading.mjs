// What makes the page of trace readable: nothing is cut off on small screens, labels lie apart, and the words are
// explained.
import assert from 'node:assert/strict';
import { PHONE, eventually } from './browser.mjs';
import { check, isLong } from './check.mjs';
import { button, counts, text } from './read.mjs';
import { goTo } from './trace.mjs';
import { assertApart, assertTargets } from './view-reading.mjs';

const LOW = { viewport: { width: 1024, height: 600 }, colorScheme: 'light' };

export async function checkTraceReading(tools) {
  await checkScreen(tools, 'trace-deep', 'phone', PHONE);
  await checkScreen(tools, 'trace-apart', '1024 x 600', LOW);
  if (isLong) {
    await checkScreen(tools, 'trace-apart', 'phone', PHONE);
    await checkScreen(tools, 'trace-deep', '1024 x 600', LOW);
  }
  await checkWords(tools);
  await checkKeys(tools);
}

async function checkScreen({ open }, name, screen, look) {
  const page = await open(name, look);
  await check(`${name}, ${screen}: every step can be read to its end, and its row is in view`, async () => {
    const { steps } = await counts(page);
    for (const step of new Set([0, 1, Math.floor(steps / 2), steps - 1])) {
      await goTo(page, step);
      await canBeRead(page, '.story:visible p:last-child');
      await canBeRead(page, 'tr.current:visible', '.steps');
      assertApart(await labelBoxes(page));
    }
    const { scrollWidth, width } = await page.evaluate(() => {
      return { scrollWidth: document.documentElement.scrollWidth, width: window.innerWidth };
    });
    assert.ok(scrollWidth <= width, `the page is ${scrollWidth} wide, the window ${width}`);
    await assertTargetsOn(page, look);
    assert.deepEqual(page.complaints, []);
  });
  await page.close();
}

const assertTargetsOn = (page, look) => (look.hasTouch ? assertTargets(page, 'button, input, tbody tr') : null);

/** Asserts that a part can be brought into view, or is in view of its list without any scrolling. */
async function canBeRead(page, selector, list) {
  const part = page.locator(selector);
  if (!list) await part.evaluate((each) => each.scrollIntoView({ block: 'nearest' }));
  const cut = await part.evaluate((each, within) => {
    const box = each.getBoundingClientRect();
    const covers = box.top < -1 || box.bottom > window.innerHeight + 1 ? ['window'] : [];
    if (within) covers.length = 0;
    for (let at = each.parentElement; at && at !== document.documentElement; at = at.parentElement) {
      const style = getComputedStyle(at);
      if (style.overflowY === 'visible') continue;
      const frame = at === document.body ? { top: 0, bottom: window.innerHeight } : at.getBoundingClientRect();
      if (box.top < frame.top - 1 || box.bottom > frame.bottom + 1) covers.push(at.className || at.tagName);
      if (within && at.matches(within)) break;
    }
    return covers;
  }, list);
  assert.deepEqual(cut, [], selector);
}

const labelBoxes = (page) =>
  page.locator('.stage .label').evaluateAll((all) =>
    all
      .filter((each) => each.style.visibility === 'visible')
      .map((each) => {
        const { left, top, right, bottom } = each.getBoundingClientRect();
        return { text: each.textContent, left, top, right, bottom };
      }),
  );

async function checkWords({ open }) {
  const page = await open('trace-margin');
  await check(
    'trace: the arrow and the text name one direction, which leads from A’s support point to the origin',
    async () => {
      await goTo(page, 0);
      const labels = await page.locator('.label').allInnerTexts();
      assert.ok(labels.includes('d') && labels.includes('−d'), labels.join());
      const story = await text(page, '.story:visible');
      assert.match(story, /d = \(/);
      assert.doesNotMatch(story, /\bn\b/);
      // The shapes' centres: B lies from A as d points in the first step.
      const shown = /d = \(([^)]*)\)/.exec(story)[1].replaceAll('−', '-').split(', ').map(Number);
      const between = await page.evaluate(() => window.__gjk.model.position);
      assert.ok(shown.reduce((sum, x, i) => sum + x * between[i], 0) > 0, `${shown} and ${between}`);
    },
  );
  await check('trace: the words explain cores and margins, with those of the pair', async () => {
    assert.equal(await page.locator('.words').isVisible(), false);
    await button(page, 'A − B').click();
    await eventually(async () => {
      const words = await text(page, '.words');
      assert.match(words, /Core and margin/);
      assert.match(words, /gem is all core and has no margin; sphere has a margin of 0\.8/);
      assert.match(words, /Minkowski difference/);
    });
    await button(page, 'steps').click();
    await eventually(async () => assert.equal(await page.locator('.story:visible').isVisible(), true));
  });
  await page.close();
}

async function checkKeys({ open }) {
  const page = await open('trace-apart');
  await check('trace: keys go through the steps without a click, and T changes the theme', async () => {
    const at = (step) => eventually(async () => assert.equal((await counts(page)).step, step));
    await page.keyboard.press('ArrowRight');
    await at(1);
    await page.keyboard.press('End');
    await at((await counts(page)).steps - 1);
    await page.keyboard.press('Home');
    await at(0);
    await page.keyboard.press('t');
    await eventually(async () =>
      assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'light'),
    );
  });
  await page.close();
  await check('trace: one iteration is one iteration', async () => {
    const one = await open('trace-one');
    assert.match(await text(one, '.summary'), /after 1 iteration\./);
    await one.close();
  });
}
