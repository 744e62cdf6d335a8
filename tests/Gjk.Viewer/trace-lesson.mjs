// The page of trace as a lesson: pseudo-code, regions, the textbook beside the exact query.
import assert from 'node:assert/strict';
import { PHONE, eventually } from './browser.mjs';
import { check, isLong } from './check.mjs';
import { button, counts, text } from './read.mjs';
import { goTo } from './trace.mjs';
import { assertSticks, assertTargets } from './view-reading.mjs';

const TABS = ['steps', 'code', 'textbook', 'A − B'];

export async function checkLesson(tools) {
  await checkLines(tools);
  const names = isLong ? ['trace-apart', 'trace-hit', 'trace-margin'] : ['trace-hit'];
  for (const name of names) await checkRegions(tools, name);
  await checkTextbook(tools);
  await checkFigure(tools);
  await checkPhone(tools);
}

async function choose(page, tab) {
  await button(page, tab).click();
  await eventually(async () => assert.equal(await page.evaluate(() => document.body.dataset.tab), names[tab]));
}

const names = { steps: 'steps', code: 'code', textbook: 'textbook', 'A − B': 'words' };

const lit = async (page) => ({
  line: (await counts(page)).line,
  text: await page.locator('li.lit:visible').innerText(),
});

async function checkLines({ open, keep }) {
  const page = await open('trace-apart');
  await check('lesson: each line is lit in its turn, with its source, and the picture follows', async () => {
    await choose(page, 'code');
    await goTo(page, 0);
    for (let i = 0; i < 6; i++) await page.keyboard.press('ArrowUp');
    const order = [];
    const isFound = async () => (await page.locator('.stage .label').allInnerTexts()).includes('w1');
    for (let i = 0; i < 7; i++) {
      const { line } = await lit(page);
      order.push(line);
      assert.match(await text(page, '.code:visible .source'), /^src\/Gjk\.Core\/\w+\/\w+\.cs: \w+$/);
      assert.equal(await isFound(), !['start', 'repeat'].includes(line), line);
      await page.keyboard.press('ArrowDown');
    }
    assert.deepEqual(order, ['start', 'repeat', 'support', 'bound', 'join', 'region', 'next']);
    const after = await counts(page);
    assert.deepEqual([after.step, after.line], [1, 'repeat']);
    await goTo(page, after.iterations - 1);
    assert.deepEqual(await lit(page), { line: 'answer', text: 'answer = v’s weights on A and B, less the margins' });
    await goTo(page, 2);
    await keep(page, 'lesson-code');
    assert.deepEqual(page.complaints, []);
  });
  await page.close();
}

async function checkRegions({ open }, name) {
  const page = await open(name);
  await check(`${name}: the origin lies in the region of what is kept, and in no other`, async () => {
    await choose(page, 'code');
    const { iterations } = await counts(page);
    let drawn = 0;
    for (let step = 0; step < iterations; step++) {
      await goTo(page, step);
      const { before, after } = await page.evaluate((at) => window.__gjk.model.steps[at], step);
      const kept = after ?? [];
      const regions = await page.locator('.region').evaluateAll((all) => {
        const mark = document.querySelector('.regions .origin');
        const [x, y] = ['cx', 'cy'].map((each) => Number(mark?.getAttribute(each)));
        return all.map((each) => {
          const holds = each.isPointInFill(new DOMPoint(x, y));
          return { corners: each.dataset.region, classes: each.getAttribute('class'), holds };
        });
      });
      assert.equal(regions.length > 0, kept.length > 0 && before.length > 0, `step ${step + 1}`);
      if (!regions.length) continue;
      drawn++;
      const holding = regions.filter((region) => region.holds);
      assert.equal(holding.length, 1, JSON.stringify(regions));
      assert.match(holding[0].classes, /here/);
      const corners = kept.map((i) => `w${i + 1}`);
      assert.deepEqual(holding[0].corners.split(' ').sort(), corners.sort());
      const skipped = regions.filter((region) => /skipped/.test(region.classes));
      assert.equal(skipped.length > 0, kept.length < 4);
      assert.ok(skipped.every((region) => !region.corners.split(' ').includes(`w${step + 1}`)));
    }
    assert.ok(drawn > 0);
    assert.deepEqual(page.complaints, []);
  });
  await page.close();
}

async function checkTextbook({ open, keep }) {
  const endings = [
    ['loop', 'Repeats', /Answer: none\. The simplex is that of step 2 again\..*for ever\..*distance 0\.25/s],
    ['trace-apart', 'NoNearer', /Answer: distance 3\.2582\d?\. The exact query says the same/s],
    ['wrong', 'Encloses', /Answer: the shapes intersect\. Exact: distance 0\.253969\..*one point/s],
    ['trace-huge', 'NotFinite', /has left the range of float\. Exact: distance 2\.9000e25/],
  ];
  for (const [name, ending, answer] of isLong ? endings : endings.slice(0, 2)) {
    const page = await open(name);
    await check(`${name}: the textbook's steps are walked beside the exact ones`, async () => {
      // An example opens on the failure.
      const { tab, step: first, textbookSteps: last } = await counts(page);
      const isExample = ['loop', 'wrong'].includes(name);
      assert.deepEqual([tab, first], isExample ? ['textbook', last - 1] : ['steps', 0]);
      if (isExample) assert.match(await text(page, '.textbook .story'), answer);
      await choose(page, 'textbook');
      const { textbookSteps, textbookEnding } = await counts(page);
      assert.equal(textbookEnding, ending);
      assert.equal(await page.locator('.textbook tbody tr').count(), textbookSteps);
      for (let step = 0; step < textbookSteps; step++) {
        await goTo(page, step);
        const story = await text(page, '.textbook .story');
        assert.match(story, /^Search: [\s\S]*Test: /);
        assert.doesNotMatch(story, /NaN|undefined|null/);
        assert.equal(await page.locator('.textbook li.lit').count(), 1);
        const labels = await page.locator('.stage .label').allInnerTexts();
        assert.ok(labels.includes(`w${step + 1}`), labels.join());
      }
      assert.match(await text(page, '.textbook .story'), answer);
      assert.equal((await page.locator('.textbook tr.rises').count()) > 0, name === 'loop');
      await keep(page, `lesson-${name}`);
      await choose(page, 'steps');
      assert.equal(await page.locator('input[type=range]').getAttribute('max'), String((await counts(page)).steps - 1));
      assert.deepEqual(page.complaints, []);
    });
    await page.close();
  }
}

async function checkFigure({ open, keep }) {
  const page = await open('trace-apart');
  await check('lesson: A − B is drawn in the plane, as far from the origin as A is from B', async () => {
    await choose(page, 'A − B');
    const lengths = await page.locator('.words line').evaluateAll((all) =>
      all.map((each) => {
        const [x1, y1, x2, y2] = ['x1', 'y1', 'x2', 'y2'].map((name) => Number(each.getAttribute(name)));
        return [x2 - x1, y2 - y1];
      }),
    );
    assert.equal(lengths.length, 2);
    const [[x, y], [u, v]] = lengths;
    assert.ok(Math.abs(x * v - y * u) < 1e-6 * (Math.abs(x * u) + Math.abs(y * v)), JSON.stringify(lengths));
    assert.ok(x * u + y * v > 0);
    await keep(page, 'lesson-words');
  });
  await page.close();
}

async function checkPhone({ open, keep }) {
  const page = await open('loop', PHONE);
  await check('lesson: every panel can be read and pressed on a phone', async () => {
    for (const tab of TABS) {
      await choose(page, tab);
      const last = page.locator('.tab:visible > :last-child');
      await last.scrollIntoViewIfNeeded();
      const { top, bottom, width } = await last.evaluate((each) => {
        const box = each.getBoundingClientRect();
        return { top: box.top, bottom: box.bottom, width: document.documentElement.scrollWidth };
      });
      assert.ok(top < 844 && bottom > 388, `${tab}: ${top} to ${bottom}`);
      assert.ok(width <= 390, `${tab}: the page is ${width} wide`);
      await assertTargets(page, 'button, input, tbody tr');
      await assertSticks(page);
      await keep(page, `lesson-phone-${names[tab]}`);
    }
    assert.deepEqual(page.complaints, []);
  });
  await page.close();
}
