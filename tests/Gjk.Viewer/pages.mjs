// Does with the pages what a user does: reads the counts, looks at colours, hovers, clicks, sorts, drags, zooms, types
// and plays the frames.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { openPage, startBrowser } from './browser.mjs';
import { check, finish } from './check.mjs';
import { checkScreens } from './screens.mjs';
import { checkTraces } from './trace.mjs';
import { checkLesson } from './trace-lesson.mjs';
import { checkTraceReading } from './trace-reading.mjs';
import { checkView } from './view.mjs';
import { checkMotion } from './view-motion.mjs';
import { checkViewReading } from './view-reading.mjs';

const folder = process.argv[2],
  only = process.argv[3];
for (const name of ['three.js', 'viewer.js'].filter((script) => existsSync(join(folder, script)))) {
  const checkedIn = readFileSync(`../../src/Gjk.Demo/viewer/dist/${name}`);
  await check(`the bundle ${name} is what its sources make`, async () =>
    assert.ok(readFileSync(join(folder, name)).equals(checkedIn)));
}

const browser = await startBrowser();
const tools = {
  folder,
  open: (name, look) => openPage(browser, join(folder, `${name}.html`), look),
  keep: (page, name) => page.screenshot({ path: join(folder, `${name}.png`) }),
};
// The pages of view and those of trace at once: each waits for its drawing most of the time.
const lanes = [
  { checkView, checkMotion, checkViewReading },
  { checkTraces, checkTraceReading, checkLesson, checkScreens },
];
await Promise.all(
  lanes.map(async (parts) => {
    for (const [name, part] of Object.entries(parts)) if (!only || name === only) await part(tools);
  }),
);
await browser.close();
finish();
