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
  return element('dl', {}, ...entries.flatMap(([term, text]) => [element('dt', { textContent: term }), element('dd', { textContent: text })]));
}

/** A group of buttons. One of them is pressed. */
export function segmented(label, choices, value, change) {
  const buttons = choices.map(([key, text]) => element('button', {
    type: 'button', textContent: text, onclick: () => { set(key); change(key); },
  }));
  function set(chosen) {
    buttons.forEach((b, i) => b.setAttribute('aria-pressed', choices[i][0] === chosen));
  }
  set(value);
  return { root: element('div', { className: 'segmented', role: 'group', 'aria-label': label }, ...buttons), set };
}

/** A slider over steps, with a button that plays them. */
export function player(name, count, change, stepMs) {
  const slider = element('input', { type: 'range', min: 0, max: Math.max(count - 1, 0), value: 0, 'aria-label': name });
  const output = element('output');
  const play = element('button', { type: 'button', className: 'plain', textContent: '▶', 'aria-label': 'play' });
  let timer = 0;
  function stop() {
    clearInterval(timer);
    timer = 0;
    play.textContent = '▶';
    play.setAttribute('aria-label', 'play');
  }
  function show(index) {
    slider.value = index;
    output.textContent = `${name} ${index + 1} of ${count}`;
  }
  play.onclick = () => {
    if (timer) return stop();
    play.textContent = '❚❚';
    play.setAttribute('aria-label', 'pause');
    timer = setInterval(() => change((Number(slider.value) + 1) % count), stepMs);
  };
  slider.oninput = () => change(Number(slider.value));
  show(0);
  return { root: element('div', { className: 'player', hidden: count < 2 }, play, slider, output), show, stop };
}

/** An entry of a legend. */
export function swatch(color, text) {
  const box = element('i');
  box.style.background = color;
  return element('span', {}, box, text);
}
