// The screens around the trials: consent, questions, calibration, instructions, breaks and the end. Each one is a
// function of the element to fill and of what to call when the person goes on.
import { element } from '../dom.js';
import { blindSpot } from './blind-spot.js';

/** A bank card in millimetres (ISO/IEC 7810, ID-1), standing. */
const CARD = { width: 53.98, height: 85.6 };

/** CSS pixels per millimetre that a screen may have, and the browser's own guess: 96 pixels an inch. */
const LEAST = 2.4, MOST = 9, GUESS = 96 / 25.4;

/** Millimetres from the eye to a screen. */
const NEAREST = 100, FURTHEST = 5000;

const go = (textContent, onclick) => element('button', { type: 'button', className: 'go', textContent, onclick });
const paragraphs = (text) => text.split('\n').map((textContent) => element('p', { textContent }));

function screen(display, title, ...children) {
  display.replaceChildren(element('div', { className: 'screen' }, element('h1', { textContent: title }), ...children));
}

export const consent = (plan) => (display, done) => {
  const agree = element('input', {
    type: 'checkbox', id: 'agree', onchange: () => { next.disabled = !agree.checked; },
  });
  const next = go('Begin', () => done());
  next.disabled = true;
  screen(display, plan.name, ...paragraphs(plan.consent),
    element('label', { className: 'check' }, agree, 'I have read this and take part of my own will.'),
    element('div', { className: 'line' }, next,
      go('Full screen', () => document.documentElement.requestFullscreen?.())));
};

export const questions = (plan, store) => (display, done) => {
  const code = element('input', { type: 'text', id: 'person', value: crypto.randomUUID().slice(0, 6), maxLength: 40 });
  const age = element('input', { type: 'number', id: 'age', min: 0, max: 120 });
  const eyes = element('select', { id: 'eyes' }, ...['', 'normal', 'with glasses or lenses', 'not corrected']
    .map((value) => element('option', { value, textContent: value || 'no answer' })));
  const note = element('p', { className: 'quiet', role: 'status' });
  const label = (text, input) => element('label', {}, element('span', { textContent: text }), input);
  screen(display, 'About you', label('Your code (no name)', code),
    ...(plan.questions ? [label('Age (optional)', age), label('Eyesight (optional)', eyes)] : []), note,
    go('Next', () => {
      const person = code.value.trim();
      if (!person) { note.textContent = 'The code must not be empty.'; return; }
      try {
        store.keep({ person, age: age.value, eyesight: eyes.value, began: new Date().toISOString() });
        done();
      } catch (error) {
        note.textContent = `This browser stores nothing (${error.message}), so a closed tab would lose everything.`;
      }
    }));
};

export const calibration = (plan, store) => (display, done) => {
  const card = element('div', { className: 'card' }, element('span', { textContent: 'card' }));
  const slider = element('input', {
    type: 'range', min: LEAST, max: MOST, step: 0.01, value: GUESS, id: 'card', 'aria-label': 'size of the card',
    oninput: fit,
  });
  const distance = element('input', {
    type: 'number', id: 'distance', min: NEAREST, max: FURTHEST, value: plan.viewingDistance,
  });
  const note = element('p', { className: 'quiet', role: 'status' });
  const spot = element('div', {}, go('Measure the distance by the blind spot', () => {
    const told = distance.value;
    blindSpot(spot, Number(slider.value), (millimetres) => {
      distance.value = measured = millimetres;
      spot.textContent = `The blind spot says ${millimetres} mm (${told} before).`;
    });
  }));
  let measured = null;
  function fit() {
    card.style.width = `${CARD.width * slider.value}px`;
    card.style.height = `${CARD.height * slider.value}px`;
  }
  fit();
  screen(display, 'Size of your screen',
    element('p', {
      textContent: 'Hold a bank card upright on the screen. Move the slider until both have the same size.',
    }),
    slider, card,
    element('label', {}, element('span', { textContent: 'From your eyes to the screen, in millimetres' }), distance),
    spot, note,
    go('Next', () => {
      const millimetres = Number(distance.value);
      if (!(millimetres >= NEAREST && millimetres <= FURTHEST)) {
        note.textContent = `Must be ${NEAREST} to ${FURTHEST} millimetres.`;
        return;
      }
      const viewingDistanceBy = millimetres === measured ? 'blind spot' : 'person';
      store.keep({ pixelsPerMillimetre: Number(slider.value), viewingDistance: millimetres, viewingDistanceBy });
      done();
    }));
};

const TASKS = {
  adjustment: ['As close as possible', 'Move the object on the right until it is as close as possible to the other '
    + 'one without touching it. Drag it, turn the wheel, use the arrow keys (with Shift: larger steps) or the buttons. '
    + 'Then press Enter or "done".'],
  constant: ['Touching or not?', 'You will see two objects for a short time. Do they touch? Answer with the keys T '
    + '(touching) and N (not touching), or with the buttons.'],
  mismatch: ['Does this look right?', 'One object has come to rest on the other one. Does it look right? Answer with '
    + 'the keys R (right) and W (wrong), or with the buttons.'],
};

export const instructions = (plan, task, isFirst) => (display, done) => {
  const [title, text] = TASKS[task];
  screen(display, title, ...(isFirst ? paragraphs(plan.instructions) : []), element('p', { textContent: text }),
    ...(plan.practice ? [element('p', { textContent: `It begins with practice: ${plan.practice} trials.` })] : []),
    go('Start', () => done()));
};

export const pause = () => (display, done) => screen(display, 'A break',
  element('p', { textContent: 'Rest your eyes as long as you like. Everything is kept.' }), go('Go on', () => done()));

export const resume = (store, total, again) => (display, done) => screen(display, 'Welcome back',
  element('p', { textContent: `${store.person}: ${store.trials.length} of ${total} trials are done, and kept.` }),
  element('div', { className: 'line' }, go('Continue', () => done()),
    go('Another person', () => again(display, done))));

/** Asks before what one person answered is thrown away. */
export const another = (store) => (display) => screen(display, 'Another person',
  element('p', { textContent: `The ${store.trials.length} trials of ${store.person} are removed from this browser. `
    + 'Save them first if they are not saved.' }),
  element('div', { className: 'line' }, go('Save the data', () => store.save()),
    go('Remove and begin', () => { store.clear(); location.reload(); }), go('Back', () => location.reload())));

export const end = (store) => (display) => screen(display, 'Thank you',
  element('p', { textContent: 'That was all. Save the data: two files, CSV and JSON, with the same trials.' }),
  element('div', { className: 'line' }, go('Save the data', () => store.save()),
    go('Another person', () => another(store)(display))));
