// The page of trace: every step is told and drawn, and the bounds meet at the answer of query.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { colorsAt, eventually } from './browser.mjs';
import { check, isLong } from './check.mjs';
import { readCsv } from './csv.mjs';
import { counts, numbers, text } from './read.mjs';

export async function checkTraces(tools) {
  await checkApart(tools);
  await checkHit(tools);
  if (isLong) await (await traced(tools, 'trace-round', 'Separated')).close();
  await checkDepth(tools);
}

/** Goes to a step by the slider, which one step has not, and waits until the page is there. */
export async function goTo(page, step) {
  const slider = page.locator('input[type=range]');
  if (await slider.isVisible()) await slider.fill(String(step));
  await eventually(async () => assert.equal((await counts(page)).step, step));
}

async function traced({ open, keep }, name, status) {
  const page = await open(name);
  await check(`${name}: every step is told and drawn`, async () => {
    const { steps, depthSteps, iterations, status: found } = await counts(page);
    assert.equal(found, status);
    assert.equal(steps, iterations + depthSteps);
    assert.equal(await page.locator('.steps:visible tbody tr').count(), steps);
    for (let step = 0; step < steps; step++) {
      await goTo(page, step);
      await checkStory(page, step, { steps, iterations, found });
    }
    assert.deepEqual(page.complaints, []);
  });
  await keep(page, name);
  return page;
}

async function checkStory(page, step, { steps, iterations, found }) {
  const story = await text(page, '.story:visible');
  const isDepth = step >= iterations;
  const growth = /^Surface: [\s\S]*Search: [\s\S]*(Growth|End): /,
    search = /^Search: [\s\S]*Bound: [\s\S]*Region: /;
  assert.match(story, isDepth ? growth : search);
  assert.doesNotMatch(story, /NaN|undefined|null/);
  assert.equal(story.includes('Answer:'), step === iterations - 1 || step === steps - 1);
  const label = isDepth ? /^p\d+$/ : new RegExp(`^w${step + 1}$`);
  const labels = await page.locator('.label').allInnerTexts();
  assert.ok(
    labels.some((each) => label.test(each)),
    labels.join(),
  );
  assert.equal(labels.includes('way out'), found === 'Overlapping' && step === steps - 1);
  assert.equal(await page.locator('tr.current:visible td').first().innerText(), String(step + 1));
}

async function checkApart(tools) {
  const page = await traced(tools, 'trace-apart', 'Separated');
  await check('trace: the bounds close in from both sides, and meet at the distance', async () => {
    const table = await numbers(page.locator('.steps:visible table'));
    for (let i = 1; i < table.length; i++) {
      assert.ok(table[i][1] >= table[i - 1][1] && table[i][2] <= table[i - 1][2], JSON.stringify(table));
    }
    assert.equal(table.at(-1)[1], table.at(-1)[2]);
    assert.ok((await text(page, '.story:visible')).includes(`distance ${table.at(-1)[1]}`));
  });
  await check('trace: the origin is a white ball on the screen', async () => {
    await page.locator('.steps:visible tbody tr').first().click();
    await eventually(async () => {
      const [color] = await colorsAt(page, [await page.evaluate(() => window.__gjk.originAt())]);
      assert.ok(
        color.every((channel) => channel > 230),
        String(color),
      );
    });
  });
  await page.close();
}

async function checkHit(tools) {
  const page = await traced(tools, 'trace-hit', 'Overlapping');
  await check('trace: the last simplex holds the origin', async () => {
    const { iterations } = await counts(page);
    await goTo(page, iterations - 1);
    assert.match(await text(page, '.story:visible'), /the origin is inside the tetrahedron/);
  });
  await page.close();
}

async function checkDepth(tools) {
  const depths = readCsv(join(tools.folder, 'deep.csv'));
  const traces = [
    ['trace-deep', 1],
    ['trace-margin', 2],
  ];
  for (const [name, b] of isLong ? traces : traces.slice(0, 1)) {
    const page = await traced(tools, name, 'Overlapping');
    const depth = -depths.find((row) => row.a === 0 && row.b === b).distance;
    await check(`${name}: the depth is that of query`, async () => {
      const shown = Number(/Answer: depth ([\d.]+)/.exec(await text(page, '.story:visible'))[1]);
      assert.ok(Math.abs(shown - depth) <= 1e-5 * depth, `${shown} for ${depth}`);
    });
    if (b === 1) await checkDepthBounds(page);
    await page.close();
  }
}

async function checkDepthBounds(page) {
  await check('trace-deep: the bounds of the depth close in and meet', async () => {
    const { depthSteps } = await counts(page);
    assert.ok(depthSteps > 2);
    const bounds = await numbers(page.locator('.steps:visible table').nth(1));
    for (let i = 1; i < bounds.length; i++) {
      assert.ok(bounds[i][1] >= bounds[i - 1][1] && bounds[i][2] <= bounds[i - 1][2], JSON.stringify(bounds));
    }
    assert.equal(bounds.at(-1)[1], bounds.at(-1)[2]);
  });
}
