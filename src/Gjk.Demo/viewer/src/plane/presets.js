// The polygons that the figures begin with. A corner is (x, y) in the polygon's own frame.

const square = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
const first = [[-1.1, -0.9], [1.1, -0.5], [0.3, 1.2]];
const second = [[-0.9, 0.2], [0.8, -1], [0.9, 1.1]];
const pentagon = [0, 1, 2, 3, 4].map((i) => {
  const angle = (2 * Math.PI * i) / 5 + 0.3;
  return [1.3 * Math.cos(angle), 1.3 * Math.sin(angle)];
});

/** The shapes of the book's programs, each about a point within it. */
const A = { corners: [[-1, -0.8], [0.6, -1], [1.2, 0.3], [0.1, 1.1], [-1.1, 0.6]], at: [-1.2, 0] };
const B = { corners: [[-0.8, -0.33], [0.6, -0.73], [0.2, 1.07]], at: [1.5, -0.17] };

export const SHAPES = {
  book: [A, B],
  loop: [A, { ...B, at: [1.49, -0.18] }],
  triangles: [{ corners: first, at: [-1.8, -0.3] }, { corners: second, at: [1.7, 0.5] }],
  touching: [{ corners: square, at: [-1, 0] }, { corners: [[0, 0], [1.5, -1.2], [1.5, 1]], at: [0, 0.25] }],
  overlap: [{ corners: pentagon, at: [-0.6, 0.1] }, { corners: second, at: [0.7, 0] }],
  parallel: [{ corners: square, at: [-1.75, 0] }, { corners: square, at: [1.75, 0.5] }],
  deep: [{ corners: pentagon, at: [-0.3, 0] }, { corners: A.corners, at: [0.4, 0.3] }],
};
