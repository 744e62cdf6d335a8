/** The keys that a slider takes for itself. */
const SLIDER = new Set(['ArrowLeft', 'ArrowRight', 'Home', 'End', 'PageUp', 'PageDown']);

/**
 * Runs the action of a pressed key, wherever the focus is. The focused element keeps the keys that it needs. An action
 * is named by its key, which is a small letter or as KeyboardEvent names it, with Shift+ before an arrow.
 */
export function onKeys(actions) {
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const { target, key } = event;
    if (target.matches?.('input') && SLIDER.has(key)) return;
    if (target.matches?.('button, summary, a') && (key === ' ' || key === 'Enter')) return;
    const name =
      key.length === 1 ? key.toLowerCase() : event.shiftKey && key.startsWith('Arrow') ? `Shift+${key}` : key;
    if (!actions[name]) return;
    event.preventDefault();
    actions[name]();
  });
}

/** What a stage does on keys: turn, zoom, and go back to the first look. */
export function stageKeys(stage, reset, turnKey = 'Shift+') {
  return {
    [`${turnKey}ArrowLeft`]: () => stage.turn(-1, 0),
    [`${turnKey}ArrowRight`]: () => stage.turn(1, 0),
    'Shift+ArrowUp': () => stage.turn(0, -1),
    'Shift+ArrowDown': () => stage.turn(0, 1),
    '+': () => stage.zoom(1),
    '=': () => stage.zoom(1),
    '-': () => stage.zoom(-1),
    0: reset,
  };
}
