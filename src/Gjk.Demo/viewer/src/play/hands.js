import { Plane, Vector3 } from 'three';

/** In CSS pixels: how near a finger or the mouse must come to the end of a velocity. */
const REACH = 24;

/** Radians for each pixel of a drag, and for each press of a key. */
const TURN = 0.01, KEY_TURN = Math.PI / 36;

/** How far a key moves a body, in units as it is drawn. */
const STEP = 0.1;

const ARROWS = {
  ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [1, 1], ArrowDown: [1, -1], PageUp: [2, -1], PageDown: [2, 1],
};

/**
 * Lets the mouse, a finger and keys move the bodies. The hands tell which body was taken hold of, and after each change
 * that something has moved.
 */
export function giveHands(view, { mode, taken, moved }) {
  watchPointer(view, mode, taken, moved);
  watchKeys(view, mode, taken, moved);
}

function watchPointer(view, mode, taken, moved) {
  const { stage, model } = view;
  if (!stage.renderer) return;
  const canvas = stage.renderer.domElement;
  let hold = null;
  // The stage's own controls listen on the canvas. They must not see a drag that begins on a body.
  stage.root.addEventListener('pointerdown', (event) => {
    if (hold || event.button > 0) return;
    hold = grab(view, event);
    stage.controls.enabled = !hold;
    if (!hold) return;
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    taken(hold.body);
  }, { capture: true });
  canvas.addEventListener('pointermove', (event) => {
    if (!hold) {
      canvas.style.cursor = event.buttons === 0 && grab(view, event) ? 'grab' : '';
      return;
    }
    if (event.pointerId !== hold.pointer) return;
    if (hold.isTip || mode() === 'move') drag(view, hold, event);
    else turn(hold, event);
    moved();
  });
  const release = (event) => {
    if (event.pointerId !== hold?.pointer) return;
    hold = null;
    stage.controls.enabled = true;
  };
  canvas.addEventListener('pointerup', release);
  canvas.addEventListener('pointercancel', release);

  function turn(hold, event) {
    const { body } = hold, [right, up] = view.axes();
    model.turn(body, up, (event.clientX - hold.x) * TURN);
    model.turn(body, right, (event.clientY - hold.y) * TURN);
    [hold.x, hold.y] = [event.clientX, event.clientY];
  }
}

/** What is under the pointer: the end of the active body's velocity, or a body. */
function grab(view, event) {
  const { model, stage } = view, at = { pointer: event.pointerId, x: event.clientX, y: event.clientY };
  if (model.question === 'impact') {
    const tip = view.tip(view.active), { x, y } = stage.project(tip);
    const isNear = Math.hypot(x - event.clientX, y - event.clientY) < REACH;
    if (isNear) return { ...at, body: view.active, isTip: true, point: tip };
  }
  const { body, point } = view.pick(event.clientX, event.clientY);
  return body < 0 ? null : { ...at, body, point };
}

/** Moves what is held in the plane of the screen. */
function drag(view, hold, event) {
  const plane = new Plane().setFromNormalAndCoplanarPoint(view.axes()[2], hold.point);
  const to = view.stage.ray(event.clientX, event.clientY).ray.intersectPlane(plane, new Vector3());
  if (!to) return;
  view.model.shift(hold.body, hold.isTip ? 7 : 4, to.clone().sub(hold.point));
  hold.point = to;
}

/** Arrows and page keys move the active body, or turn it; with Shift they do the other. */
function watchKeys(view, mode, taken, moved) {
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target.closest?.('input, select, textarea, summary, pre')) return;
    const letter = 'ab'.indexOf(event.key.toLowerCase());
    if (letter >= 0) return taken(letter);
    const arrow = ARROWS[event.key];
    if (!arrow) return;
    event.preventDefault();
    const [axis, sign] = arrow, axes = view.axes();
    if ((mode() === 'move') !== event.shiftKey) {
      view.model.move(view.active, axes[axis].multiplyScalar(sign * STEP));
    } else {
      const about = [1, 0, 2][axis];
      view.model.turn(view.active, axes[about], (axis === 1 ? -sign : sign) * KEY_TURN);
    }
    moved();
  });
}
