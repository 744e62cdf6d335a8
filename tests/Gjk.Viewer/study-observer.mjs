// A scripted observer: does a study in a page as a person would, by keys or by touch, with answers that follow from the
// drawn gap and a seed. It is no person, and its answers are no data.
import { until } from './play-browser.mjs';

/** The gap below which the observer says "touching", in units of the scene. */
const THRESHOLD = 0.012;

export class Observer {
  /** @param {{page: object, isTouch: boolean, keep: Function}} how The page, how it is used, what keeps pictures. */
  constructor({ page, isTouch, keep }) {
    Object.assign(this, { page, isTouch, keep, seen: new Set() });
  }

  press(text) {
    const button = this.page.locator('button', { hasText: new RegExp(`^${text}$`) });
    return this.isTouch ? button.tap() : button.click();
  }

  async begin(code) {
    await this.reachCalibration(code);
    await this.page.locator('#card').fill('4');
    await this.press('Next');
  }

  /** The screens before the calibration. */
  async reachCalibration(code = 'scripted') {
    const { page } = this;
    await this.see('consent');
    await page.locator('#agree').check();
    await this.press('Begin');
    await this.see('questions');
    await page.locator('#person').fill(code);
    await this.press('Next');
    await this.see('calibration');
  }

  /** Answers until so many trials are stored, or all of them. */
  async answer(most = Infinity) {
    const { page } = this;
    for (;;) {
      const state = await this.state();
      if (state.screen === 'Thank you' || state.stored >= most) return state;
      if (state.screen) {
        await this.see(state.screen.replace(/\W+/g, '-').toLowerCase());
        await this.press(state.screen === 'A break' ? 'Go on' : state.screen === 'Welcome back' ? 'Continue' : 'Start');
      } else if (state.buttons.includes('done')) {
        await this.adjust(state);
      } else if (state.buttons.length) {
        await this.judge(state);
      }
      await page.waitForTimeout(5);
    }
  }

  state() {
    return this.page.evaluate(() => ({
      screen: document.querySelector('.screen h1')?.textContent ?? '', stored: window.__gjk.store.trials.length,
      headline: document.querySelector('.headline')?.textContent ?? '',
      buttons: [...document.querySelectorAll('.controls button:not(:disabled)')].map((each) => each.textContent),
    }));
  }

  /** Moves by drag, wheel, keys or buttons, and never looks at the number. */
  async adjust({ stored }) {
    const { page, isTouch } = this;
    await this.see('adjustment');
    const box = await page.locator('.canvas').boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    if (isTouch) {
      for (let i = 0; i <= stored % 3; i++) await this.press(i % 2 ? '▶' : '◀◀');
    } else if (stored % 3 === 0) {
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x - 14, y + 3, { steps: 2 });
      await page.mouse.up();
    } else if (stored % 3 === 1) {
      await page.mouse.move(x, y);
      await page.mouse.wheel(0, 100);
    } else {
      await page.keyboard.press('Shift+ArrowLeft');
      await page.keyboard.press('ArrowRight');
    }
    if (isTouch) await this.press('done');
    else await page.keyboard.press('Enter');
    await this.stored(stored + 1);
  }

  /** Says what the asked gap looks like to it; for what rests, whether little of it is wrong. */
  async judge({ stored, buttons }) {
    const isRight = buttons[0].startsWith('looks');
    await this.see(isRight ? 'mismatch' : 'constant');
    const first = isRight ? stored % 2 === 0 : await this.isTouching(stored);
    if (this.isTouch) await this.page.locator('.controls button').nth(first ? 0 : 1).tap();
    else await this.page.keyboard.press(isRight ? (first ? 'r' : 'w') : first ? 't' : 'n');
    await this.stored(stored + 1);
  }

  isTouching(stored) {
    return this.page.evaluate(([count, threshold]) => {
      const { app } = window.__gjk, [a, b] = app.view.bodies;
      const noise = 0.012 * Math.sin(count * 12.9898);
      const row = app.engine.ask('signed', [[0, 1]])[0];
      return a.visible && b.visible && row.distance + noise < threshold;
    }, [stored, THRESHOLD]);
  }

  async stored(count) {
    const end = Date.now() + 60_000;
    while ((await this.state()).stored < count) {
      if (Date.now() > end) throw new Error(`trial ${count} is not stored`);
      await this.page.waitForTimeout(10);
    }
  }

  /** Keeps one picture of each kind of screen. */
  async see(name) {
    if (this.seen.has(name)) return;
    this.seen.add(name);
    await this.keep(name);
  }
}

export const ready = (page) => until(page, () => document.querySelector('.jspsych-content')?.children.length > 0);
