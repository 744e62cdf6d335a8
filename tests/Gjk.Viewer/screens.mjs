// Screenshots to look at: both pages, wide and narrow, light and dark, and as someone sees them who cannot tell red
// from green.
import assert from 'node:assert/strict';
import { colorsAt, eventually, settled } from './browser.mjs';
import { check, isLong } from './check.mjs';

const SIZES = { wide: { width: 1280, height: 800 }, phone: { width: 390, height: 844 } };

export async function checkScreens({ open, keep }) {
  // What nobody looks at need not be drawn.
  if (isLong) await checkLooks({ open, keep });
  await checkDeuteranopia({ open, keep });
}

async function checkLooks({ open, keep }) {
  for (const name of ['cubes', 'trace-apart']) {
    for (const [size, viewport] of Object.entries(SIZES)) {
      for (const colorScheme of ['dark', 'light']) {
        const isPhone = size === 'phone';
        const page = await open(name, { viewport, colorScheme, hasTouch: isPhone, isMobile: isPhone });
        await check(`${name}, ${size}, ${colorScheme}: a picture to look at, without errors`, async () => {
          await page.evaluate(() => window.__gjk.show?.(2));
          await settled(page);
          await keep(page, `screen-${name}-${size}-${colorScheme}`);
          assert.deepEqual(page.complaints, []);
        });
        await page.close();
      }
    }
  }
}

async function checkDeuteranopia({ open, keep }) {
  for (const name of ['cubes', 'trace-apart']) {
    const page = await open(name);
    await check(`${name}: a picture as with deuteranopia`, async () => {
      const session = await page.context().newCDPSession(page);
      await session.send('Emulation.setEmulatedVisionDeficiency', { type: 'deuteranopia' });
      await page.evaluate(() => window.__gjk.show?.(2));
      await eventually(async () => {
        if (name !== 'cubes') return;
        // The simulation is on: what is green no longer looks so.
        const [[r, g]] = await colorsAt(page, [await page.evaluate(() => window.__gjk.positionOf(1))]);
        assert.ok(Math.abs(r - g) < 0.15 * g, `${r}, ${g}`);
      });
      await settled(page);
      await keep(page, `screen-${name}-deuteranopia`);
    });
    await page.close();
  }
}
