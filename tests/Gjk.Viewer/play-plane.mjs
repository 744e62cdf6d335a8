// Uses the figures of the plane as a reader does.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { openPage, until } from './play-browser.mjs';
import { check } from './check.mjs';
import { readCsv } from './csv.mjs';
import { faultsOfLook } from './looks.mjs';
import { assertSame, distanceRow } from './play-answers.mjs';
import { demo } from './play-demo.mjs';

/** The searches, whether their shapes share a point, and how many steps they have at least. */
const SEARCHES = [
  ['search', false, 3], ['overlap', true, 3], ['parallel', false, 3], ['simplex', false, 3], ['bounds', false, 3],
  ['weights', false, 3], ['regions', false, 3],
];

/** Steps of a figure that are looked at, where it has many. */
const MOST_STEPS = 12;

export async function checkPlane(context, folder) {
  const page = await openPage(context, join(folder, 'play.html'), '#plane=search');
  await checkHands(page, folder);
  for (const [figure, isHit, least] of SEARCHES) {
    await check(`plane: ${figure} has the answer of the demo, and every step tells the truth`, async () => {
      await choose(page, figure);
      await assertDemoAgrees(page, folder, isHit);
      const { walk, stages, layers } = await page.evaluate(() => {
        const { walk: steps, stages: all, layers: shown } = window.__gjk.lesson;
        return { walk: steps, stages: all, layers: [...shown] };
      });
      assert.ok(walk.length >= least, `${walk.length} steps`);
      assertBounds(walk, (await answerOf(page)).distance);
      for (let stage = 0; stage < stages.length; stage++) await assertStage(page, stage, stages[stage], layers);
      assert.deepEqual(page.complaints, []);
    });
  }
  await checkLessons(page, folder);
  await page.close();
  await checkEmbedded(context, folder);
}

const choose = (page, figure) => page.evaluate((name) => window.__gjk.choose(name), figure);

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

async function assertStage(page, stage, { step, isReduced }, layers) {
  const seen = await page.evaluate((index) => {
    const { go, difference } = window.__gjk;
    go(index);
    const region = difference.root.querySelector('.chosen');
    return {
      story: document.querySelector('.story').textContent, count: document.querySelector('.count').textContent,
      labels: [...document.querySelectorAll('text')].map((each) => each.textContent),
      has: { regions: Boolean(region), line: Boolean(difference.root.querySelector('.plane')) },
      hasOrigin: region && region.isPointInFill(new DOMPoint(0, 0)),
    };
  }, stage);
  assert.match(seen.count, new RegExp(`^step ${stage + 1} of \\d+$`));
  assert.doesNotMatch(seen.story, /NaN|undefined|null|[{}]/);
  assert.equal(seen.has.regions, isReduced && step > 0 && layers.includes('regions'));
  assert.equal(seen.has.line, !isReduced && layers.includes('line'));
  assert.equal(seen.labels.some((label) => /·/.test(label)) && !layers.includes('weights'), false, seen.labels.join());
  if (seen.has.regions) assert.ok(seen.hasOrigin, `the region of stage ${stage} lacks the origin`);
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
    await drag(await page.evaluate(() => window.__gjk.world.place(window.__gjk.lesson.turnedBy(0))), [50, 20]);
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
    const step = () => page.evaluate(() => window.__gjk.lesson.step);
    assert.equal(await step(), 0, 'a figure opens at its first step');
    await page.locator('[aria-label="next step"]').click();
    assert.equal(await step(), 1);
    await page.keyboard.press('PageDown');
    assert.equal(await step(), 2);
    await page.locator('[aria-label="step back"]').click();
    assert.equal(await step(), 1);
  });
  await check('plane: a shape cannot leave the picture, and neither can its handle', async () => {
    await page.keyboard.press('b');
    for (let i = 0; i < 60; i++) await page.keyboard.press('ArrowUp');
    assert.deepEqual(await faultsOf(page), []);
  });
  await check('plane: a figure is chosen, and the address follows', async () => {
    await page.locator('select').selectOption('parallel');
    assert.match(page.url(), /#plane=parallel$/);
    assert.equal((await answerOf(page)).distance, 1.5);
    assert.deepEqual(page.complaints, []);
  });
}

/** The figures that are no walk of the library's search. */
async function checkLessons(page, folder) {
  const lesson = (body) => page.evaluate(body);
  await check('plane: the tip of d turns it, and w is the furthest corner', async () => {
    await choose(page, 'support');
    const from = await lesson(() => window.__gjk.world.place(window.__gjk.lesson.handles()[0].at));
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x - 90, from.y - 20, { steps: 3 });
    await page.mouse.up();
    const { w, d, corners, found } = await lesson(() => {
      const { lesson: l, model } = window.__gjk;
      return { w: l.points().w, d: l.direction, corners: model.difference(), found: l.found.length };
    });
    const along = (p) => p[0] * d[0] + p[1] * d[1];
    assert.ok(d[0] < 0 && found > 1, `${d}, ${found}`);
    assert.ok(Math.abs(along(w) - Math.max(...corners.map(along))) < 1e-9);
  });
  await check('plane: the depth is the demo’s for the same shapes as thick plates, and its bounds close in', async () => {
    await choose(page, 'depth');
    const { walk, answer, record } = await lesson(() => {
      const { lesson: l, engine, model } = window.__gjk;
      const plate = ({ corners, at }) => {
        const all = corners.flatMap(([x, y]) => [-9, 9].map((z) => `${x} ${y} ${z}`));
        return `mesh ${all.length} ${all.join(' ')} @ 0 0 0 1 ${at.join(' ')} 0`;
      };
      return { walk: l.walk, answer: l.answer, record: engine.checked(`gjk1 ${model.bodies.map(plate).join(' ')}`) };
    });
    const file = join(folder, 'plane-depth.csv');
    demo('query', '--record', record, '--depth', '--out', file);
    const [row] = readCsv(file);
    assert.ok(walk.length > 2 && Math.abs(row.distance + answer.depth) < 1e-6, `${row.distance} for ${answer.depth}`);
    walk.forEach((step, i) => {
      assert.ok(step.height <= answer.depth + 1e-9 && step.atMost >= answer.depth - 1e-9, `step ${i}`);
      assert.ok(i === 0 || step.height >= walk[i - 1].height - 1e-9, `step ${i} is lower than the one before`);
    });
  });
  await check('plane: the search in float comes to the same simplex again, and plays on', async () => {
    await choose(page, 'loop');
    const seen = await lesson(() => {
      const { lesson: l, go } = window.__gjk;
      go(1000);
      const { names } = l.at(1000);
      return { repeats: l.repeats, names, next: l.at(1001).names, count: document.querySelector('.count').textContent };
    });
    assert.ok(seen.repeats > 0, 'it ends');
    assert.deepEqual(seen.names, seen.next);
    assert.equal(seen.count, 'step 1001, and no end');
    await page.locator('[aria-label="play"]').click();
    await until(page, () => window.__gjk.lesson.step > 1000);
    await page.locator('[aria-label="pause"]').click();
  });
  await check('plane: the cast is the demo’s, and the shapes touch at its time', async () => {
    await choose(page, 'cast');
    const gaps = await lesson(() => {
      const { lesson: l, model } = window.__gjk, { fraction } = l.impact;
      return [fraction - 1e-3, fraction + 1e-3].map((time) => {
        l.step = time * (l.count - 1);
        return l.whileMoved(() => { model.ask(); return model.answer.distance; });
      });
    });
    assert.ok(gaps[0] > 0 && gaps[0] < 0.01 && gaps[1] === 0, gaps.join());
    await choose(page, 'cast');
  });
  await check('plane: a word lights up its part', async () => {
    await choose(page, 'origin');
    await page.locator('.story .part', { hasText: /^origin$/ }).first().hover();
    assert.equal(await page.locator('circle.lit').getAttribute('data-part'), 'origin');
    await page.evaluate(() => window.postMessage({ part: 'shortest' }, '*'));
    await until(page, () => document.querySelectorAll('line.lit').length === 2);
    assert.deepEqual(page.complaints, []);
  });
}

/** What is wrong in the pictures as they are: labels on one another or cut off, handles that are not whole. */
async function faultsOf(page) {
  const cut = await page.evaluate(() => [...document.querySelectorAll('.picture circle.handle')].filter((handle) => {
    const b = handle.getBoundingClientRect(), frame = handle.ownerSVGElement.getBoundingClientRect();
    return b.left < frame.left - 1 || b.right > frame.right + 1 || b.top < frame.top - 1 || b.bottom > frame.bottom + 1;
  }).length);
  // Where a simplex fills A - B, no place is free; then a label may lie on the outline.
  const faults = (await page.evaluate(faultsOfLook)).filter((fault) => !fault.includes('lies on polygon.difference'));
  return [...faults, ...Array(cut).fill('a handle is cut off')];
}

async function checkEmbedded(context, folder) {
  const page = await openPage(context, join(folder, 'play.html'), '#plane=search&embed');
  const figures = await page.evaluate(() => [...document.querySelectorAll('select option')].map(({ value }) => value));
  for (const [width, height] of [[624, 600], [340, 844]]) {
    await check(`plane: embedded at ${width}, every step of each figure is legible, and no label lies on anything`, async () => {
      await page.setViewportSize({ width, height });
      await until(page, () => window.__gjk.world.wide > 0);
      const faults = [];
      for (const figure of figures) {
        await choose(page, figure);
        const { count, first } = await page.evaluate(() => {
          const { lesson } = window.__gjk;
          return { count: Number.isFinite(lesson.count) ? lesson.count : 8, first: lesson.step };
        });
        assert.equal(first, 0);
        const said = await page.evaluate(() => document.body.scrollHeight);
        const steps = Math.min(count, MOST_STEPS);
        for (let i = 0; i < steps; i++) {
          await page.evaluate((step) => window.__gjk.go(step), Math.floor((i * (count - 1)) / Math.max(1, steps - 1)));
          for (const fault of await faultsOf(page)) faults.push(`${figure}, step ${i + 1}: ${fault}`);
          const tall = await page.evaluate(() => document.body.scrollHeight);
          if (tall > said) faults.push(`${figure}, step ${i + 1}: ${tall} high, not ${said}`);
        }
        await page.screenshot({ path: join(folder, `plane-${figure}-${width}.png`) });
      }
      assert.deepEqual(faults, []);
      const hidden = await page.evaluate(() => (
        ['.bar', '.help'].map((name) => document.querySelector(name).getBoundingClientRect().height)));
      assert.deepEqual(hidden, [0, 0]);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width);
      assert.deepEqual(page.complaints, []);
    });
  }
  await page.close();
}
