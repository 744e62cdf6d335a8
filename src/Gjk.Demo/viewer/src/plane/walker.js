import { element } from '../dom.js';
import { button } from '../play/parts.js';

/** Buttons that play the steps of a figure, and walk them one by one, and a slider over them where they have an end. */
export function walker(go, lesson) {
  let timer = 0;
  const named = (text, label, onclick) => Object.assign(button(text, onclick), { title: label, ariaLabel: label });
  const play = named('▶', 'play', () => (timer ? stop() : start()));
  const back = named('◀', 'step back', () => { stop(); go(lesson().step - 1); });
  const next = named('▶|', 'next step', () => { stop(); go(lesson().step + 1); });
  const slider = element('input', { type: 'range', min: 0, oninput: () => { stop(); go(Number(slider.value)); } });
  const count = element('output', { className: 'count' });
  const root = element('div', { className: 'line walker' }, play, back, next, slider, count);

  function start() {
    if (lesson().step >= lesson().count - 1) go(0);
    timer = setInterval(() => {
      go(lesson().step + 1);
      if (lesson().step >= lesson().count - 1) stop();
    }, lesson().pace);
    name();
  }

  function stop() {
    clearInterval(timer);
    timer = 0;
    name();
  }

  function name() {
    play.textContent = timer ? '❚❚' : '▶';
    play.title = play.ariaLabel = timer ? 'pause' : 'play';
  }

  /** Shows which step the figure is at. */
  function show() {
    const { count: all, step, steps } = lesson(), isTime = steps === 'time';
    root.hidden = all < 2;
    for (const each of [back, next]) each.hidden = isTime;
    back.disabled = step === 0;
    next.disabled = step >= all - 1;
    slider.hidden = !Number.isFinite(all);
    slider.max = all - 1;
    slider.value = step;
    slider.ariaLabel = steps;
    count.textContent = isTime ? `time ${(step / (all - 1)).toFixed(2)}`
      : `${steps} ${step + 1}${Number.isFinite(all) ? ` of ${all}` : ', and no end'}`;
  }

  return { root, show, stop };
}
