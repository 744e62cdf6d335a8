// A program that has only the package for npm: every kind of shape, every query, a scene.
import assert from 'node:assert/strict';
import { load } from 'gjk-core';

const gjk = await load();
assert.equal(await load(), gjk);
const box = gjk.box([0.5, 0.5, 0.5]), ball = gjk.sphere(1);

const apart = gjk.distance(box, {}, ball, { position: [3, 0, 0] });
assert.equal(apart.status, 'Separated');
assert.equal(apart.distance, 1.5);
assert.deepEqual(apart.pointB, [2, 0, 0]);

const turned = { position: [2, 0, 0], rotation: [0, 0, Math.SQRT1_2, Math.SQRT1_2] };
assert.ok(Math.abs(gjk.distance(box, {}, gjk.capsule(0.25, 1), turned).distance - 0.25) < 1e-6);

const deep = gjk.depth(box, {}, ball, { position: [1, 0, 0] });
assert.deepEqual([deep.status, deep.distance], ['Overlapping', -0.5]);

const hit = gjk.cast(box, {}, [0, 0, 0], ball, { position: [3, 0, 0] }, [-4, 0, 0]);
assert.deepEqual([hit.status, hit.fraction], ['Hit', 0.375]);

const touching = gjk.contacts(box, {}, box, { position: [0.75, 0, 0] });
assert.equal(touching.points.length, 4);
assert.ok(touching.points.every((p) => p.gap === -0.25 && Array.isArray(p.point)));

const floor = gjk.halfSpace([0, 2, 0], -1), stick = gjk.segment([0, 0, 0], [0, 1, 0]);
assert.equal(gjk.distance(floor, {}, stick, { position: [0, 3, 0] }).distance, 3.5);
assert.equal(gjk.contacts(floor, {}, box, {}).points.length, 4);
assert.equal(gjk.distance(floor, {}, floor, {}).status, 'InvalidShape');
const club = gjk.taperedCapsule(0.5, 0.25, 1), tile = gjk.triangle([-9, 0, -9], [9, 0, -9], [0, 0, 9]);
assert.equal(gjk.distance(club, { position: [0, 2, 0] }, tile, {}).distance, 0.75);
assert.equal(gjk.distance(gjk.rounded(stick, 0.5), {}, ball, { position: [3, 0.5, 0] }).distance, 1.5);
assert.throws(() => gjk.halfSpace([0, 0, 0], 1), /^RangeError: normal must not be zero, but is 0,0,0$/);
assert.throws(() => gjk.rounded({}, 1), /^TypeError: shape must be a shape/);

// Sizes are floats, as in the library: 0.1 is not a double here.
assert.equal(gjk.distance(gjk.sphere(0.1), {}, gjk.point(), { position: [0.1, 0, 0] }).status, 'Overlapping');

const tetrahedron = gjk.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]);
const scene = gjk.scene();
const shapes = [box, tetrahedron, gjk.cone(1, 1), gjk.cylinder(1, 1), gjk.ellipsoid([1, 2, 3]), gjk.point()];
shapes.forEach((shape, i) => assert.equal(scene.add(shape, { position: [20 * i, 0, 0] }), i));
assert.deepEqual(scene.pairsWithin(1), []);
scene.setPose(1, { position: [0, 1, 0] });
assert.deepEqual(scene.pairsWithin(1).map((p) => [p.a, p.b, p.distance]), [[0, 1, 0.5]]);
assert.throws(() => gjk.sphere(-1), /^RangeError: radius must not be negative, but is -1$/);
assert.throws(() => gjk.sphere(1e39), /^TypeError: radius must be a finite number, but is 1e\+39$/);
assert.throws(() => gjk.capsule(1, -2), /^RangeError: halfHeight must not be negative, but is -2$/);
assert.throws(() => gjk.box([1, -1, 1]), /^RangeError: halfExtents must not be negative, but is 1,-1,1$/);
assert.throws(() => gjk.mesh([]), /^TypeError: points must be an array of at least one point/);
assert.throws(() => gjk.scene().setPose(0, {}), /^RangeError: body must be a number that add returned, but is 0$/);
assert.throws(() => gjk.scene().pairsWithin(NaN), /^RangeError: distance must be at least 0, but is NaN$/);
for (const bad of [() => gjk.ellipsoid([0, 1, 1]), () => gjk.cone(0, 0), () => gjk.cylinder(3e38, 3e38)]) {
  try {
    bad();
  } catch (error) {
    assert.doesNotMatch(error.message, /word/i);
  }
}
assert.throws(() => gjk.sphere('wide'), /^TypeError: radius must be a finite number, but is wide$/);
assert.throws(() => gjk.box([1, 2]), /^TypeError: halfExtents must be 3 finite numbers, but is 1,2$/);
assert.throws(() => gjk.mesh([[0, 0, 0], [1, 0]]), /^TypeError: points\[1\] must be 3 finite numbers, but is 1,0$/);
assert.throws(
  () => gjk.distance(box, { rotation: [0, 0, 0, 2] }, ball), /^RangeError: rotation must have length 1, but is 0,0,0,2$/);
assert.throws(() => gjk.distance(box, ball), /^TypeError: b must be a shape, such as box/);
assert.throws(() => gjk.distance(box, { position: [0, NaN, 0] }, ball), /^TypeError: position must be 3 finite/);
