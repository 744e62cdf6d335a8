import { Vector3 } from 'three';

const FEATURES = ['vertex', 'edge', 'triangle', 'tetrahedron'];

/** Steps of an algorithm on a pair, as the pictures and the tables need them. Drawn numbers are times the unit. */
export class Walk {
  constructor(steps, unit) {
    this.steps = steps;
    this.unit = unit;
    this.depth = null;
  }

  /** How many steps are shown: those of the distance, and then those of the depth. */
  get count() {
    return this.steps.length + this.depthSteps.length;
  }

  get depthSteps() {
    return this.depth?.steps ?? [];
  }

  isDepth(at) {
    return Boolean(this.depth) && at >= this.steps.length && at < this.count;
  }

  isLast(at) {
    return at === Math.max(this.count - 1, 0);
  }

  drawn([x, y, z]) {
    return new Vector3(x * this.unit, y * this.unit, z * this.unit);
  }

  /** A vertex is named after the step that found it. */
  vertexName(index) {
    return `w${index + 1}`;
  }

  names(indices) {
    return [...indices].sort((a, b) => a - b).map((i) => this.vertexName(i));
  }

  /** Names a feature by its vertices. */
  feature(indices) {
    return `${FEATURES[indices.length - 1]} ${this.names(indices).join(' ')}`;
  }

  /** The points of both shapes whose difference is the simplex's nearest point. */
  witnesses(step) {
    const mix = (key) => {
      const add = (sum, i, k) => sum.addScaledVector(this.drawn(this.steps[i][key]), step.weights[k] ?? 0);
      return step.after.reduce(add, new Vector3());
    };
    return [mix('onA'), mix('onB')];
  }
}
