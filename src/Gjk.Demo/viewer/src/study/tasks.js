// The trials themselves. Each one shows the view, waits for the person, and hands over a row of the data. The library's
// distance is in the row and never on the screen.
import { element } from '../dom.js';

const KEYS = { constant: ['t', 'n'], mismatch: ['r', 'w'] };
const WORDS = { constant: ['touching', 'not touching'], mismatch: ['looks right', 'looks wrong'] };

/** How long feedback stays after a practice trial, in milliseconds. */
const FEEDBACK = 900;

const button = (textContent, onclick, properties = {}) =>
  element('button', { type: 'button', textContent, onclick, ...properties });

/** Sets the view of a trial up: the view, the row so far, and a function that measures a position. */
function prepare(app, trial) {
  const { place, drawn } = app.placed(trial);
  const { view } = app;
  const { view: look, camera } = trial;
  view.show({ surfaces: app.surfacesOf(trial), reach: app.reachOf(trial, place), view: look, camera });
  const began = performance.now();
  const row = (position, values) => {
    const distance = place.distance(position, drawn), { pixelsPerMillimetre, viewingDistance } = app.store.state;
    const pixels = distance * view.pixelsPerUnit;
    const radians = Math.atan(pixels / pixelsPerMillimetre / viewingDistance);
    return {
      trial: trial.number, task: trial.task, kind: trial.kind ?? 'trial', pair: trial.pair.name, view: trial.view.name,
      collider: trial.collider ?? '', start: trial.start ?? '', gap: trial.gap ?? '', distance, answer: '', pixels,
      seconds: (performance.now() - began) / 1000, arcminutes: (radians * 180 * 60) / Math.PI,
      record: place.record(position, drawn), ...values,
    };
  };
  const put = (position) => {
    place.tell(position, drawn);
    view.place(place.poses);
  };
  return { place, row, put };
}

function frame(app, display, title, ...controls) {
  const head = element('p', { className: 'headline', role: 'status', textContent: title });
  display.replaceChildren(
    element('div', { className: 'trial' }, element('div', { className: 'picture' }, app.view.root, head),
      element('div', { className: 'controls' }, ...controls)));
  app.view.resize();
  return head;
}

/** Says after a practice trial what was there, but not how far. */
function finish(head, trial, row, text, done) {
  if (trial.kind !== 'practice' || !text) return done(row);
  head.textContent = text;
  return setTimeout(() => done(row), FEEDBACK);
}

const seen = (distance) => (distance > 0 ? 'they are apart' : 'they overlap');

export function adjustment(app, trial) {
  return (display, done) => {
    const { fine, coarse } = app.plan.adjustment, { view } = app;
    const by = (step) => () => move(step);
    const head = frame(app, display, 'as close as possible, without touching',
      button('◀◀', by(-coarse), { 'aria-label': 'nearer by a large step' }),
      button('◀', by(-fine), { 'aria-label': 'nearer' }), button('▶', by(fine), { 'aria-label': 'further' }),
      button('▶▶', by(coarse), { 'aria-label': 'further by a large step' }),
      button('done', () => end(), { className: 'go' }));
    const { place, row, put } = prepare(app, trial);
    let position = place.position(trial.start), dragged = null;
    put(position);

    function move(step) {
      position = Math.fround(Math.min(Math.max(position + step, place.low), Math.max(place.high, 1)));
      put(position);
    }
    function key(event) {
      if (event.key === 'Enter') { event.preventDefault(); end(); }
      const side = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (side) { event.preventDefault(); move(side * (event.shiftKey ? coarse : fine)); }
    }
    function wheel(event) {
      event.preventDefault();
      move(-Math.sign(event.deltaY) * (event.shiftKey ? coarse : fine));
    }
    function down(event) {
      dragged = event.clientX;
      view.root.setPointerCapture(event.pointerId);
    }
    function drag(event) {
      if (dragged === null) return;
      move((event.clientX - dragged) * view.unitsPerPixel);
      dragged = event.clientX;
    }
    const up = () => { dragged = null; };
    const listeners = { wheel, pointerdown: down, pointermove: drag, pointerup: up, pointercancel: up };
    for (const [name, listener] of Object.entries(listeners))
      view.root.addEventListener(name, listener, { passive: false });
    document.addEventListener('keydown', key);

    function end() {
      document.removeEventListener('keydown', key);
      for (const [name, listener] of Object.entries(listeners)) view.root.removeEventListener(name, listener);
      const result = row(position, {});
      finish(head, trial, result, seen(result.distance), done);
    }
  };
}

/** Waits for one of two answers by key or button. */
function answerOf(task, controls, answered) {
  const give = (answer) => {
    document.removeEventListener('keydown', key);
    for (const each of controls.querySelectorAll('button')) each.disabled = true;
    answered(answer);
  };
  const key = (event) => {
    const at = KEYS[task].indexOf(event.key.toLowerCase());
    if (at >= 0 && !event.repeat) give(at === 0 ? 1 : 0);
  };
  document.addEventListener('keydown', key);
  controls.replaceChildren(...WORDS[task].map((word, i) =>
    button(`${word} (${KEYS[task][i].toUpperCase()})`, () => give(i === 0 ? 1 : 0), { className: 'go' })));
}

export function constant(app, trial) {
  return (display, done) => {
    const { cross, milliseconds, mask } = app.plan.constant;
    const head = frame(app, display, '');
    const { place, row, put } = prepare(app, trial);
    const position = place.position(trial.gap);
    const result = row(position, {});
    app.view.bodies.forEach((body) => { body.visible = false; });
    put(position);
    head.textContent = '+';
    head.classList.add('cross');
    setTimeout(() => {
      head.textContent = '';
      head.classList.remove('cross');
      app.view.bodies.forEach((body) => { body.visible = true; });
      put(position);
      setTimeout(() => {
        app.view.cover();
        setTimeout(ask, mask);
      }, milliseconds);
    }, cross);

    function ask() {
      const began = performance.now();
      head.textContent = 'did they touch?';
      answerOf('constant', display.querySelector('.controls'), (answer) => {
        result.answer = answer;
        result.seconds = (performance.now() - began) / 1000;
        finish(head, trial, result, seen(result.distance), done);
      });
    }
  };
}

export function mismatch(app, trial) {
  return (display, done) => {
    const head = frame(app, display, 'does this look right?');
    const { place, row, put } = prepare(app, trial);
    const position = place.position(0);
    put(position);
    answerOf('mismatch', display.querySelector('.controls'), (answer) => {
      finish(head, trial, row(position, { answer }), '', done);
    });
  };
}
