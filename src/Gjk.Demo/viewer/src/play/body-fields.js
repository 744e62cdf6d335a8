import { element } from '../dom.js';
import { KINDS, ROUNDING, sizesOf, wordsFor } from './catalog.js';

/** The choice of a body's shape, and its sizes. */
export function bodyFields(index, model, given, changed) {
  const letter = 'AB'[index];
  const choices = new Map();
  const select = element('select', {
    'aria-label': `shape of ${letter}`, onchange: () => choose(choices.get(select.value)),
  });
  const sizes = element('div', { className: 'sizes' });
  const message = element('p', { className: 'quiet', role: 'status' });
  const root = element('fieldset', { className: `body ${letter.toLowerCase()}` },
    element('legend', { textContent: letter }), select, sizes, message);

  /** Adds a group of choices. */
  function offer(label, bodies) {
    const group = element('optgroup', { label });
    for (const body of bodies) {
      const value = String(choices.size);
      choices.set(value, body);
      group.append(element('option', { value, textContent: body.name }));
    }
    select.append(group);
  }

  function choose({ name, kind = null, words, motion }) {
    const own = kind ? sizesOf(kind) : undefined;
    set({ name, kind, sizes: own, words: words ?? wordsFor(kind, own), ...(motion ? { motion: [...motion] } : {}) });
    if (!motion) model.settle(index);
    model.measure();
    show();
    changed();
  }

  function set(body) {
    try {
      model.replace(index, body);
      message.textContent = '';
    } catch (error) {
      message.textContent = error.message;
    }
  }

  /** Shows the body's sizes. */
  function show() {
    const { kind, name } = model.bodies[index];
    const at = [...choices].find(([, choice]) => choice.name === name && (choice.kind ?? null) === kind);
    select.value = at?.[0] ?? '';
    const fields = kind ? [...KINDS[kind].fields, ROUNDING] : [];
    sizes.replaceChildren(...fields.map(([field], i) => size(field, i, KINDS[kind].isSigned && field !== ROUNDING[0])));
  }

  function size(field, i, isSigned) {
    const input = element('input', {
      type: 'number', step: 0.1, value: model.bodies[index].sizes[i], ...(isSigned ? {} : { min: 0 }),
      oninput: () => {
        const { kind, name, sizes: before } = model.bodies[index];
        const value = Number(input.value);
        if (input.value === '' || !Number.isFinite(Math.fround(value)) || (!isSigned && value < 0)) {
          message.textContent = `${field}: ${isSigned ? 'must be a number' : 'must be a number, at least 0'}`;
          return;
        }
        const changedSizes = before.map((old, k) => (k === i ? value : old));
        set({ name, kind, sizes: changedSizes, words: wordsFor(kind, changedSizes) });
        changed();
      },
    });
    return element('label', {}, element('span', { textContent: field }), input);
  }

  offer('shapes', Object.keys(KINDS).map((kind) => ({ name: kind, kind })));
  for (const { label, bodies } of given) offer(label, bodies);
  show();
  return { root, offer, show, choose };
}
