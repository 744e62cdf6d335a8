// The distance from the eye to the screen by the eye's blind spot. The left eye looks at a square; a dot runs away from
// it to the left, and is not seen where it falls on the optic nerve. From the square that is at 13.5 degrees (Li, Joo,
// Yeatman and Reinecke 2020, "Controlling for participants' viewing distance in large-scale, psychophysical online
// experiments using a virtual chinrest", Scientific Reports 10:904), so the screen's size gives the distance.
import { element } from '../dom.js';

/** Degrees from where the eye looks to its blind spot. */
const DEGREES = 13.5;

/** Millimetres a second. */
const SPEED = 30;

/** Runs of which the middle one counts. */
const RUNS = 5;

/** Fills an element with the measurement, and calls with the millimetres. */
export function blindSpot(root, pixelsPerMillimetre, done) {
  const dot = element('span', { className: 'dot', hidden: true });
  const field = element('div', { className: 'blind' }, dot, element('span', { className: 'square' }));
  const note = element('p', { className: 'quiet', role: 'status' });
  const button = element('button', { type: 'button', className: 'go', textContent: 'Run', onclick: press });
  const seen = [];
  let start = 0;
  root.replaceChildren(
    element('p', {
      textContent: 'Close or cover your right eye, and look at the square with the left one all the time. Press "Run": '
        + `a dot moves to the left. Press "Gone" when it disappears. ${RUNS} runs.`,
    }), field, note, button);
  button.focus();

  const reach = () => field.clientWidth - 40;
  const pixels = () => ((performance.now() - start) / 1000) * SPEED * pixelsPerMillimetre;

  function move() {
    if (!start || !root.isConnected) return;
    dot.style.right = `${pixels()}px`;
    if (pixels() <= reach()) requestAnimationFrame(move);
    else rest('The dot came to the end of the screen. Go nearer to the screen, and try again.');
  }

  function rest(text) {
    start = 0;
    dot.hidden = true;
    button.textContent = 'Run';
    note.textContent = text;
  }

  function press() {
    if (!start) {
      start = performance.now();
      dot.hidden = false;
      button.textContent = 'Gone';
      note.textContent = `Run ${seen.length + 1} of ${RUNS}.`;
      requestAnimationFrame(move);
      return;
    }
    seen.push(distanceOf(pixels() / pixelsPerMillimetre));
    if (seen.length < RUNS) rest(`${seen.length} of ${RUNS} runs are done.`);
    else done(middle(seen));
  }
}

/** The distance at which so many millimetres are seen under the angle of the blind spot. */
const distanceOf = (millimetres) => millimetres / Math.tan((DEGREES * Math.PI) / 180);

const middle = (values) => Math.round([...values].sort((a, b) => a - b)[(values.length - 1) / 2]);
