import { element } from '../dom.js';

/** Velocity and turn of a body. */
export function motionFields(model, index, changed) {
  const inputs = [7, 8, 9, 10, 11, 12].map((at) => element('input', {
    type: 'number', step: 0.1,
    'aria-label': `${at < 10 ? 'velocity' : 'turn'} ${'xyz'[(at - 7) % 3]} of ${'AB'[index]}`,
    oninput: (event) => {
      const value = Math.fround(event.target.value);
      if (Number.isFinite(value)) model.bodies[index].motion[at] = value;
      changed();
    },
  }));
  const three = (textContent, fields) => element('div', { className: 'three' },
    element('span', { textContent }), ...fields);
  const root = element('fieldset', { className: 'motion' },
    element('legend', { textContent: `${'AB'[index]} in a frame` }),
    three('moves by', inputs.slice(0, 3)), three('turns by', inputs.slice(3)));
  const read = () => inputs.forEach((input, i) => {
    if (input !== document.activeElement) input.value = Number(model.bodies[index].motion[7 + i].toPrecision(4));
  });
  return { root, read, show: (isShown) => { root.hidden = !isShown; if (isShown) read(); } };
}
