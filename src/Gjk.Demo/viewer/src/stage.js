import {
  AmbientLight,
  Color,
  DirectionalLight,
  HemisphereLight,
  PerspectiveCamera,
  Raycaster,
  Scene,
  Spherical,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { element } from './dom.js';
import { COLORS, theme } from './theme.js';

/** The first look at a scene: from the front, a little from the right and from above. */
const FIRST_LOOK = new Vector3(0.34, 0.42, 1).normalize();

/** What one press of a key does: a turn in radians, a factor of the distance. */
const TURN = Math.PI / 24,
  ZOOM = 1.2;

/** A canvas that shows a three.js scene. It can be turned and zoomed, and it draws only after a change. */
export class Stage {
  constructor() {
    this.root = element('div', { className: 'canvas' });
    this.scene = new Scene();
    this.scene.background = new Color(COLORS.back);
    this.camera = new PerspectiveCamera(35, 1, 0.01, 4000);
    this.drawn = [];
    this.scene.add(new HemisphereLight(0xffffff, 0x3a4352, 1.5), new AmbientLight(0xffffff, 0.25));
    const sun = new DirectionalLight(0xffffff, 1.9);
    sun.position.set(-0.5, 0.9, 0.6);
    this.camera.add(sun);
    this.scene.add(this.camera);
    try {
      this.renderer = new WebGLRenderer({ antialias: true });
    } catch {
      this.say('This browser cannot draw in 3D (WebGL 2 is missing or switched off). The figures beside are complete.');
      return;
    }
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    this.root.append(canvas);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.dampingFactor = 0.12;
    this.controls.enableDamping = true;
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => {
      this.balls = null;
    });
    new ResizeObserver(() => this.resize()).observe(this.root);
    theme.onChange(() => {
      this.scene.background.set(COLORS.back);
      this.draw();
    });
  }

  /** Whether the canvas fills its place, and nothing is left to draw. */
  get isSettled() {
    if (!this.renderer) return true;
    const { clientWidth, clientHeight } = this.renderer.domElement;
    return !this.asked && clientWidth === this.root.clientWidth && clientHeight === this.root.clientHeight;
  }

  /** Calls a function after every drawing. */
  onDraw(listener) {
    this.drawn.push(listener);
  }

  /** Shows a text instead of a picture. */
  say(textContent) {
    this.root.append(element('div', { className: 'message', textContent }));
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.root;
    if (!this.renderer || !width || !height) return;
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.balls) this.fit(this.balls);
    this.drawNow();
  }

  /** Requests a drawing. Several requests before the next drawing cost only one. */
  draw() {
    if (!this.renderer || this.asked) return;
    this.asked = requestAnimationFrame(() => this.drawNow());
  }

  drawNow() {
    cancelAnimationFrame(this.asked);
    this.asked = 0;
    if (!this.renderer) return;
    this.controls.update();
    this.renderer.render(this.scene, this.camera);
    for (const listener of this.drawn) listener();
  }

  /**
   * Moves the camera so that all balls [{center, radius}] are just in view. It does so again when the window changes,
   * until the user moves the camera.
   */
  fit(balls, look = FIRST_LOOK) {
    this.balls = balls;
    this.look = this.look ?? look;
    if (!this.renderer) return;
    // Without damping, an update discards the motion that has not run out yet.
    this.controls.enableDamping = false;
    this.controls.update();
    this.controls.enableDamping = true;
    const target = middle(balls);
    const right = new Vector3(0, 1, 0).cross(this.look).normalize();
    const up = this.look.clone().cross(right);
    const tall = Math.tan((this.camera.fov * Math.PI) / 360) * 0.94;
    const wide = tall * this.camera.aspect;
    let distance = 0;
    for (const { center, radius } of balls) {
      const to = center.clone().sub(target);
      const depth = to.dot(this.look) + radius * 0.5;
      distance = Math.max(
        distance,
        depth + (Math.abs(to.dot(right)) + radius) / wide,
        depth + (Math.abs(to.dot(up)) + radius) / tall,
      );
    }
    distance = distance || 10;
    this.camera.near = distance / 500;
    this.camera.far = distance * 40;
    this.camera.position.copy(target).addScaledVector(this.look, distance);
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(target);
    this.draw();
  }

  /** Turns the view by steps to the side and down. */
  turn(aside, down) {
    if (!this.renderer) return;
    const from = this.camera.position.clone().sub(this.controls.target),
      at = new Spherical().setFromVector3(from);
    at.theta += aside * TURN;
    at.phi += down * TURN;
    this.moveTo(at.makeSafe());
  }

  /** Comes nearer by steps, or goes away. */
  zoom(nearer) {
    if (!this.renderer) return;
    const at = new Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
    at.radius *= ZOOM ** -nearer;
    this.moveTo(at);
  }

  moveTo(spherical) {
    this.balls = null;
    this.camera.position.setFromSpherical(spherical).add(this.controls.target);
    this.controls.update();
    this.draw();
  }

  /** A ray through a point of the window. */
  ray(clientX, clientY) {
    const box = this.renderer.domElement.getBoundingClientRect();
    const ray = new Raycaster();
    ray.setFromCamera(
      new Vector2(((clientX - box.left) / box.width) * 2 - 1, 1 - ((clientY - box.top) / box.height) * 2),
      this.camera,
    );
    return ray;
  }

  /** The position of a point of the scene in the window, in CSS pixels. */
  project(point) {
    const p = point.clone().project(this.camera);
    const box = this.root.getBoundingClientRect();
    return { x: box.left + ((p.x + 1) / 2) * box.width, y: box.top + ((1 - p.y) / 2) * box.height, depth: p.z };
  }

  /** The size of a pixel at a point, in units of the scene. */
  pixelAt(point) {
    return (
      (2 * Math.tan((this.camera.fov * Math.PI) / 360) * this.camera.position.distanceTo(point)) /
      Math.max(this.root.clientHeight, 1)
    );
  }
}

function middle(balls) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  for (const { center, radius } of balls) {
    low.min(center.clone().subScalar(radius));
    high.max(center.clone().addScalar(radius));
  }
  return balls.length ? low.add(high).multiplyScalar(0.5) : new Vector3();
}
