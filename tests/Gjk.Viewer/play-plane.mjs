// Uses the figures of the plane as a reader does.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { openPage, until } from './play-browser.mjs';
import { check } from './check.mjs';
import { readCsv } from './csv.mjs';
import { assertSame, distanceRow } from './play-answers.mjs';
import { demo } from './play-demo.mjs';

/** The figures, whether their shapes share a point, and how many steps the search has at least. */
const FIGURES = [
  ['triangles', false, 3], ['touching', true, 3], ['overlap', true, 3], ['parallel', false, 3], ['origin', false, 3],
];

export async function checkPlane(context, folder) {
  for (const [figure, isHit, least] of FIGURES) {
    const page = await openPage(context, join(folder, 'play.html'), `#plane=${figure}`);
    await check(`plane: ${figure} has the answer of the demo, and every step tells the truth`, async () => {
      await assertDemoAgrees(page, folder, isHit);
      // Not the whole model: its bodies hold the scene that is drawn, which takes a minute to send.
      const { steps, stages } = await page.evaluate(() => {
        const { steps, stages } = window.__gjk.model;
        return { steps, stages };
      });
      assert.ok(steps.length >= least, `${steps.length} steps`);
      assertBounds(steps, (await answerOf(page)).distance);
      for (let stage = 0; stage < stages.length; stage++) await assertStage(page, stage, stages[stage]);
      await page.screenshot({ path: join(folder, `plane-${figure}.png`) });
      assert.deepEqual(page.complaints, []);
    });
    if (figure === 'triangles') await checkHands(page, folder);
    await page.close();
  }
  await checkEmbedded(context, folder);
}

const answerOf = (page) => page.evaluate(() => window.__gjk.model.answer);

async function assertDemoAgrees(page, folder, isHit) {
  const file = join(folder, 'plane.csv');
  demo('query', '--record', await page.evaluate(() => window.__gjk.engine.record(0, 1)), '--out', file);
  const answer = await answerOf(page);
  assertSame(readCsv(file), [answer], distanceRow);
  if (isHit !== undefined) assert.equal(answer.status, isHit ? 'Overlapping' : 'Separated');
}

/** The bounds of all steps hold, and weights make the nearest point. */
function assertBounds(steps, distance) {
  const tiny = 1e-6;
  for (const { lower, upper, after, nearest } of steps) {
    assert.ok(lower <= distance + tiny, `${lower} for ${distance}`);
    if (!after) continue;
    assert.ok(upper >= distance - tiny, `${upper} for ${distance}`);
    const sum = after.reduce((all, { weight }) => all + weight, 0);
    assert.ok(Math.abs(sum - 1) < tiny, `the weights are ${sum}`);
    for (const axis of [0, 1]) {
      const mean = after.reduce((all, { weight, step }) => all + weight * steps[step].w[axis], 0);
      assert.ok(Math.abs(mean - nearest[axis]) < tiny, `${mean} for ${nearest[axis]}`);
    }
  }
}

async function assertStage(page, stage, { step, isReduced }) {
  const seen = await page.evaluate((index) => {
    const { go, difference } = window.__gjk;
    go(index);
    const region = difference.root.querySelector('.chosen');
    return {
      story: document.querySelector('.story').textContent, count: document.querySelector('.count').textContent,
      labels: [...document.querySelectorAll('text')].map((each) => each.textContent),
      hasOrigin: region && region.isPointInFill(new DOMPoint(0, 0)),
    };
  }, stage);
  assert.match(seen.count, new RegExp(`^step ${step + 1} of \\d+, ${isReduced ? 'reduce' : 'support'}$`));
  assert.doesNotMatch(seen.story, /NaN|undefined|null/);
  assert.equal(/hatched region|triangle/.test(seen.story), isReduced && step > 0);
  if (isReduced && step > 0) assert.ok(seen.hasOrigin, `the region of stage ${stage} lacks the origin`);
  const label = isReduced ? 'v' : `w${step + 1} = a${step + 1} − b${step + 1}`;
  assert.ok(seen.labels.includes(label) && seen.labels.includes('origin'), seen.labels.join());
}

async function checkHands(page, folder) {
  const drag = async (from, by) => {
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + by[0], from.y + by[1], { steps: 4 });
    await page.mouse.up();
  };
  const bodies = () => page.evaluate(() => window.__gjk.model.bodies.map(({ at, angle }) => ({ at, angle })));
  await check('plane: a drag moves a polygon, its handle turns it, and the answer is the demo’s', async () => {
    const before = await bodies();
    await drag(await page.evaluate(() => window.__gjk.world.place(window.__gjk.model.bodies[1].at)), [-45, 60]);
    const moved = await bodies();
    assert.ok(moved[1].at[0] < before[1].at[0] - 0.2 && moved[1].at[1] < before[1].at[1] - 0.2, JSON.stringify(moved));
    assert.deepEqual(moved[0], before[0]);
    await assertDemoAgrees(page, folder);
    await drag(await page.evaluate(() => window.__gjk.world.place(window.__gjk.world.handle(0))), [50, 20]);
    const turned = await bodies();
    assert.ok(turned[0].angle < -0.2, JSON.stringify(turned));
    assert.deepEqual(turned[0].at, before[0].at);
    await assertDemoAgrees(page, folder);
  });
  await check('plane: keys and buttons move, turn and walk', async () => {
    const before = await bodies();
    await page.keyboard.press('b');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Shift+ArrowLeft');
    const after = await bodies();
    assert.ok(after[1].at[1] > before[1].at[1] && after[1].angle > before[1].angle, JSON.stringify(after));
    const stage = () => page.evaluate(() => window.__gjk.model.stage);
    await page.locator('[aria-label="first step"]').click();
    assert.equal(await stage(), 0);
    await page.locator('[aria-label="next step"]').click();
    assert.equal(await stage(), 1);
    await page.keyboard.press('PageDown');
    assert.equal(await stage(), 2);
    await page.locator('[aria-label="step back"]').click();
    assert.equal(await stage(), 1);
  });
  await check('plane: a figure is chosen, and the address follows', async () => {
    await page.locator('select').selectOption('parallel');
    assert.match(page.url(), /#plane=parallel$/);
    assert.equal((await answerOf(page)).distance, 1.5);
    assert.deepEqual(page.complaints, []);
  });
}

async function checkEmbedded(context, folder) {
  await check('plane: embedded there is only the figure, at the sizes of a book, with nothing cut off', async () => {
    const page = await openPage(context, join(folder, 'play.html'), '#plane=overlap&embed');
    for (const [width, height] of [[700, 460], [390, 640], [1280, 800]]) {
      await page.setViewportSize({ width, height });
      await until(page, () => window.__gjk.world.wide > 0);
      const { wide, tall, hidden } = await page.evaluate(() => ({
        wide: document.documentElement.scrollWidth, tall: document.body.scrollHeight,
        hidden: ['.bar', '.help'].map((name) => document.querySelector(name).getBoundingClientRect().height),
      }));
      assert.ok(wide <= width && tall <= height, `${wide} x ${tall} of ${width} x ${height}`);
      assert.deepEqual(hidden, [0, 0]);
      for (const figure of await page.locator('.picture').all()) {
        const box = await figure.boundingBox();
        assert.ok(box.width >= 300 && box.height >= 140, JSON.stringify(box));
      }
      await page.screenshot({ path: join(folder, `plane-embed-${width}.png`) });
    }
    assert.deepEqual(page.complaints, []);
    await page.close();
  });
}
