export type Vector = readonly [number, number, number];

/** Where a shape is; left out, it is at the origin, not turned. The quaternion is x, y, z, w, of length 1. */
export interface Pose {
  position?: Vector;
  rotation?: readonly [number, number, number, number];
}

/** A shape about its own origin. Axes of capsules, cylinders and cones are y. Sizes are rounded to floats. */
export interface Shape {
  readonly words: string;
}

export interface Distance {
  status: 'Separated' | 'Overlapping' | 'IterationLimit' | 'InvalidInput' | 'InvalidShape' | 'BeyondMaxDistance';
  /** 0 when overlapping; from depth, minus the depth. */
  distance: number;
  /** Never above the true distance. */
  lowerBound: number;
  pointA: number[];
  pointB: number[];
  /** A unit vector from A to B; from depth, the direction in which B leaves A. */
  normal: number[];
  iterations: number;
}

export interface Cast {
  status: 'Hit' | 'Miss' | 'OverlappingAtStart' | 'IterationLimit' | 'InvalidInput' | 'InvalidShape';
  /** Of the way: 0 to 1. */
  fraction: number;
  /** Where they touch, and the unit vector from A to B there; NaN after a miss. */
  point: number[];
  normal: number[];
  iterations: number;
}

export interface Contacts {
  /** A unit vector from A to B. */
  normal: number[];
  /** Points on A, and how far B is from each along the normal: negative where they overlap. */
  points: { point: number[]; gap: number }[];
}

export interface Scene {
  /** Adds a body and returns its number, from 0. */
  add(shape: Shape, pose?: Pose): number;
  setPose(body: number, pose: Pose): void;
  /** Every pair of bodies at most this far apart, without asking all pairs. */
  pairsWithin(distance: number): (Distance & { a: number; b: number })[];
}

/** Every function throws a TypeError where an argument is no number, and a RangeError where it is out of range. */
export interface Gjk {
  point(): Shape;
  sphere(radius: number): Shape;
  segment(a: Vector, b: Vector): Shape;
  triangle(a: Vector, b: Vector, c: Vector): Shape;
  capsule(radius: number, halfHeight: number): Shape;
  /** The hull of two balls at the ends of an axis along y. */
  taperedCapsule(topRadius: number, bottomRadius: number, halfHeight: number): Shape;
  box(halfExtents: Vector): Shape;
  cylinder(radius: number, halfHeight: number): Shape;
  cone(radius: number, halfHeight: number): Shape;
  ellipsoid(radii: Vector): Shape;
  /** The convex hull of the points. */
  mesh(points: readonly Vector[]): Shape;
  /** All points x with normal · x at most the offset: without end, so two of them give InvalidShape. */
  halfSpace(normal: Vector, offset: number): Shape;
  /** All points at most this far from a shape. */
  rounded(shape: Shape, radius: number): Shape;
  distance(a: Shape, poseA: Pose, b: Shape, poseB: Pose): Distance;
  depth(a: Shape, poseA: Pose, b: Shape, poseB: Pose): Distance;
  /** When two shapes that move by their velocities over one frame first touch. */
  cast(a: Shape, poseA: Pose, velocityA: Vector, b: Shape, poseB: Pose, velocityB: Vector): Cast;
  /** Up to four points that are at most maxGap apart; left out, 0. */
  contacts(a: Shape, poseA: Pose, b: Shape, poseB: Pose, maxGap?: number): Contacts;
  scene(): Scene;
}

/** Starts the runtime, once for all callers. */
export function load(): Promise<Gjk>;
