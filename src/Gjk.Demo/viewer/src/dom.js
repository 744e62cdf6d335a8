/** Creates an element with properties, attributes (whose names have a dash) and children. */
export function element(tag, properties = {}, ...children) {
  const result = document.createElement(tag);
  for (const [key, value] of Object.entries(properties)) {
    if (key.includes('-') || key === 'role') result.setAttribute(key, value);
    else result[key] = value;
  }
  result.append(...children);
  return result;
}

/** A list of terms with their descriptions. */
export function definitions(entries) {
  const parts = entries.flatMap(([term, text]) => [
    element('dt', { textContent: term }),
    element('dd', { textContent: text }),
  ]);
  return element('dl', {}, ...parts);
}

export function button(textContent, onclick, properties = {}) {
  return element('button', { type: 'button', className: 'plain', textContent, onclick, ...properties });
}

/** A button that is pressed or not. */
export function toggle(text, title, change) {
  const root = button(text, () => set(root.getAttribute('aria-pressed') !== 'true'), { title, 'aria-pressed': false });
  function set(isOn) {
    root.setAttribute('aria-pressed', isOn);
    change(isOn);
  }
  return root;
}

/** A group of buttons. One of them is pressed. */
export function segmented(label, choices, value, change) {
  const press = (key) => () => {
    set(key);
    change(key);
  };
  const buttons = choices.map(([key, textContent]) =>
    element('button', { type: 'button', textContent, onclick: press(key) }),
  );
  function set(chosen) {
    buttons.forEach((b, i) => b.setAttribute('aria-pressed', choices[i][0] === chosen));
  }
  set(value);
  return { root: element('div', { className: 'segmented', role: 'group', 'aria-label': label }, ...buttons), set };
}

/** Panels under a row of buttons, of which one panel shows: [name, text, panel]. */
export function tabs(label, choices, value, change = () => {}) {
  const chosen = segmented(
    label,
    choices.map(([name, text]) => [name, text]),
    value,
    show,
  );
  chosen.root.classList.add('tabs');
  function show(name) {
    chosen.set(name);
    for (const [each, , panel] of choices) panel.hidden = each !== name;
    change(name);
  }
  show(value);
  return { root: chosen.root, show };
}

/** A slider over steps, with a button that plays them. */
export function player(name, count, change, stepMs) {
  const slider = element('input', { type: 'range', min: 0, max: Math.max(count - 1, 0), value: 0, 'aria-label': name });
  const output = element('output');
  const play = button('▶', toggleTimer, { 'aria-label': 'play' });
  let timer = 0;
  function stop() {
    clearInterval(timer);
    timer = 0;
    play.textContent = '▶';
    play.setAttribute('aria-label', 'play');
  }
  function toggleTimer() {
    if (timer) return stop();
    play.textContent = '❚❚';
    play.setAttribute('aria-label', 'pause');
    timer = setInterval(() => change((Number(slider.value) + 1) % count), stepMs);
  }
  function show(index) {
    slider.value = index;
    output.textContent = `${name} ${index + 1} of ${count}`;
  }
  function resize(newCount) {
    count = newCount;
    slider.max = Math.max(count - 1, 0);
    root.hidden = count < 2;
  }
  function go(by) {
    const next = Math.max(0, Math.min(count - 1, Number(slider.value) + by));
    if (next !== Number(slider.value)) change(next);
  }
  slider.oninput = () => change(Number(slider.value));
  show(0);
  const root = element('div', { className: 'player', hidden: count < 2 }, play, slider, output);
  return { root, show, stop, go, resize, toggle: toggleTimer };
}

/** An entry of a legend: the name of a colour of the theme, and a text. */
export function swatch(color, text, isHatched = false) {
  const box = element('i', { className: isHatched ? 'hatched' : '' });
  box.style.backgroundColor = `var(--c-${color})`;
  return element('span', {}, box, text);
}
