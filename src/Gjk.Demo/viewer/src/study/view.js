import {
  Box3, BufferAttribute, Color, DataTexture, DirectionalLight, DoubleSide, Group, HemisphereLight, LineBasicMaterial,
  LineSegments, Mesh, MeshLambertMaterial, NearestFilter, PCFShadowMap, PerspectiveCamera, PlaneGeometry,
  RepeatWrapping, Scene, ShadowMaterial, Vector3, WebGLRenderer,
} from 'three';
import { element } from '../dom.js';
import { edges, surface } from '../geometry.js';

/** The camera's angle in degrees, and how much of the picture the objects fill. */
const ANGLE = 30, FILLED = 0.8;

/** The thickness of a drawn point or segment, when both objects together have a reach of 1. */
const THIN = 0.01;

const COLORS = [0x8fb4e8, 0xe8b48f], EDGE = 0x14181f;

/** Turns of a turning camera, in degrees a second. */
const TURNING = 20;

/** Draws two objects and nothing else: no distance, no mark of where they are nearest. */
export class StudyView {
  constructor() {
    this.mask = element('canvas', { className: 'mask', width: 64, height: 48, hidden: true });
    this.root = element('div', { className: 'canvas' }, this.mask);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(ANGLE, 1, 0.05, 50);
    this.sun = new DirectionalLight(0xffffff, 2.2);
    this.sun.position.set(-1.2, 3, 1.6);
    this.sun.shadow.mapSize.set(1024, 1024);
    Object.assign(this.sun.shadow.camera, { left: -2.5, right: 2.5, top: 2.5, bottom: -2.5, near: 0.1, far: 10 });
    this.sun.shadow.bias = -0.0005;
    this.floor = new Mesh(new PlaneGeometry(12, 12).rotateX(-Math.PI / 2), new ShadowMaterial({ opacity: 0.35 }));
    this.floor.receiveShadow = true;
    this.bodies = [new Group(), new Group()];
    this.scene.add(new HemisphereLight(0xffffff, 0x5a6372, 1.3), this.sun, this.floor, ...this.bodies);
    this.renderer = new WebGLRenderer({ antialias: true });
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.root.prepend(this.renderer.domElement);
    this.materials = new Map();
    this.line = new LineBasicMaterial({ color: EDGE });
    new ResizeObserver(() => this.resize()).observe(this.root);
    this.noise();
  }

  /** Shows two surfaces in a view, with a camera at angles in degrees. Where they are, place says. */
  show({ surfaces, reach, view, camera }) {
    this.unit = 1 / reach;
    this.angles = { ...camera };
    this.isTurning = view.camera === 'turning';
    this.start = performance.now();
    this.scene.background = new Color(view.background);
    this.sun.castShadow = this.floor.visible = view.shadow;
    this.renderer.shadowMap.enabled = view.shadow;
    surfaces.forEach((shape, i) => this.make(this.bodies[i], shape, COLORS[i], view));
    this.mask.hidden = true;
    this.isShown = true;
    if (this.isTurning) this.turn();
  }

  make(group, shape, color, view) {
    for (const old of group.children) old.geometry.dispose();
    group.clear();
    const geometry = surface(shape, this.unit, THIN);
    if (view.texture) project(geometry);
    const mesh = new Mesh(geometry, this.material(color, shape.dimension < 3, view.texture));
    mesh.castShadow = mesh.receiveShadow = view.shadow;
    group.add(mesh);
    if (shape.dimension > 1 && shape.edges.length) group.add(new LineSegments(edges(shape, this.unit), this.line));
  }

  /** Materials are kept: a new one would have its shader compiled, which delays the view that is to be timed. */
  material(color, isThin, hasTexture) {
    const key = `${color} ${isThin} ${hasTexture}`;
    if (!this.materials.has(key)) {
      this.materials.set(key, new MeshLambertMaterial({
        color, side: isThin ? DoubleSide : 0, map: hasTexture ? checks() : null,
        polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
      }));
    }
    return this.materials.get(key);
  }

  /** Puts both bodies at poses of the library. */
  place(poses) {
    poses.forEach((pose, i) => {
      const group = this.bodies[i];
      group.quaternion.set(...pose.slice(0, 4)).normalize();
      group.position.set(...pose.slice(4, 7)).multiplyScalar(this.unit);
    });
    this.floor.position.y = Math.min(...this.bodies.map((body) => new Box3().setFromObject(body).min.y)) - THIN;
    this.draw();
  }

  draw() {
    const { clientWidth: wide, clientHeight: high } = this.root;
    if (!wide || !high) return;
    const seconds = (performance.now() - this.start) / 1000;
    const yaw = ((this.angles.yaw + (this.isTurning ? TURNING * seconds : 0)) * Math.PI) / 180;
    const pitch = (this.angles.pitch * Math.PI) / 180;
    this.camera.aspect = wide / high;
    this.camera.updateProjectionMatrix();
    this.camera.position.set(
      Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)).multiplyScalar(this.distance);
    this.camera.lookAt(new Vector3());
    this.renderer.render(this.scene, this.camera);
  }

  /** From the camera to the place where both objects meet, so that they fill the shorter side of the picture. */
  get distance() {
    const aspect = this.root.clientWidth / this.root.clientHeight;
    return 1 / (FILLED * Math.tan((ANGLE * Math.PI) / 360) * Math.min(1, aspect));
  }

  /** CSS pixels for a unit of the scene at the place where both objects meet. */
  get pixelsPerUnit() {
    return (this.root.clientHeight * this.unit) / (2 * Math.tan((ANGLE * Math.PI) / 360) * this.distance);
  }

  /** Units of the scene along x for a pixel to the right on the screen. */
  get unitsPerPixel() {
    const along = Math.cos((this.angles.yaw * Math.PI) / 180);
    return (Math.abs(along) < 0.2 ? 0.2 * (Math.sign(along) || 1) : along) ** -1 / this.pixelsPerUnit;
  }

  cover() {
    this.isShown = false;
    this.mask.hidden = false;
  }

  turn() {
    if (!this.isShown || !this.root.isConnected) return;
    this.draw();
    requestAnimationFrame(() => this.turn());
  }

  resize() {
    this.renderer.setSize(this.root.clientWidth, this.root.clientHeight, false);
    if (this.isShown) this.draw();
  }

  /** Fills the mask with squares of random grey. */
  noise() {
    const context = this.mask.getContext('2d'), image = context.createImageData(this.mask.width, this.mask.height);
    for (let i = 0; i < image.data.length; i += 4) {
      image.data.fill(40 + Math.floor(Math.random() * 180), i, i + 3);
      image.data[i + 3] = 255;
    }
    context.putImageData(image, 0, 0);
  }
}

/** A chessboard. */
function checks() {
  const grey = [255, 150, 150, 255].flatMap((light) => [light, light, light, 255]);
  const map = new DataTexture(new Uint8Array(grey), 2, 2);
  map.wrapS = map.wrapT = RepeatWrapping;
  map.magFilter = NearestFilter;
  map.needsUpdate = true;
  return map;
}

/** Lays the texture on each triangle along the axis that it faces most. */
function project(geometry) {
  const at = geometry.attributes.position, normals = geometry.attributes.normal, uv = new Float32Array(2 * at.count);
  for (let i = 0; i < at.count; i++) {
    const n = [normals.getX(i), normals.getY(i), normals.getZ(i)].map(Math.abs);
    const p = [at.getX(i), at.getY(i), at.getZ(i)];
    const axis = n.indexOf(Math.max(...n));
    uv.set([0, 1, 2].filter((k) => k !== axis).map((k) => 3 * p[k]), 2 * i);
  }
  geometry.setAttribute('uv', new BufferAttribute(uv, 2));
}
