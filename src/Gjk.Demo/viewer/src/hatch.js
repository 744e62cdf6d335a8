import { InstancedBufferAttribute } from 'three';

/** In CSS pixels: from one stripe to the next, and the breadth of one. */
const PERIOD = 9,
  BREADTH = 3;

/** The share of its colour that a body keeps under a stripe. */
const SHADE = 0.5;

/**
 * Stripes across some instances of a mesh, so that they do not differ from the others by their colour alone. The
 * stripes run across the screen, so they look the same on bodies of any size and shape.
 */
export class Hatch {
  constructor(mesh, pixelRatio) {
    this.flags = new InstancedBufferAttribute(new Float32Array(mesh.count), 1);
    mesh.geometry.setAttribute('hatch', this.flags);
    mesh.material.onBeforeCompile = (shader) => {
      shader.vertexShader = shader.vertexShader.replace(
        'void main() {',
        'attribute float hatch;\nvarying float vHatch;\nvoid main() {\n  vHatch = hatch;',
      );
      shader.fragmentShader = shader.fragmentShader
        .replace('void main() {', `varying float vHatch;\nvoid main() {`)
        .replace('#include <color_fragment>', `#include <color_fragment>\n${stripes(pixelRatio)}`);
    };
  }

  set(instance, isHatched) {
    this.flags.setX(instance, isHatched ? 1 : 0);
    this.flags.needsUpdate = true;
  }
}

const stripes = (pixelRatio) => `
  float across = mod((gl_FragCoord.x + gl_FragCoord.y) / ${(1.41421 * pixelRatio).toFixed(5)}, ${PERIOD.toFixed(1)});
  float stripe = clamp(${(BREADTH / 2 + 0.5).toFixed(2)} - abs(across - ${(PERIOD / 2).toFixed(2)}), 0.0, 1.0);
  diffuseColor.rgb *= 1.0 - ${(1 - SHADE).toFixed(2)} * stripe * vHatch;`;
