// Reads the parts of a binary glTF 2.0: each mesh of the scene's nodes, in its place, as the corners of its triangles.
import { Matrix4, Quaternion, Vector3 } from 'three';

/** The first bytes of the file and of its chunks, as numbers: "glTF", "JSON" and "BIN". */
const FILE = 0x46546c67, JSON_CHUNK = 0x4e4f534a, BINARY_CHUNK = 0x004e4942;

const FLOAT = 5126, HEAD = 12, CHUNK_HEAD = 8;

/**
 * The parts: {name, words}.
 * @throws {Error} The bytes are not such a file, or keep their corners in a way that is not read here.
 */
export function partsOfGlb(buffer) {
  const { json, binary } = chunks(new DataView(buffer)), parts = [];
  const visit = (index, parent) => {
    const node = json.nodes[index], world = parent.clone().multiply(matrixOf(node));
    for (const { attributes, extensions } of json.meshes?.[node.mesh]?.primitives ?? []) {
      if (extensions?.KHR_draco_mesh_compression) throw new Error('its meshes are compressed');
      const corners = new Set(positions(json, binary, attributes.POSITION)
        .map((corner) => corner.applyMatrix4(world).toArray().map(Math.fround).join(' ')));
      const name = node.name ?? json.meshes[node.mesh].name ?? `mesh ${parts.length + 1}`;
      parts.push({ name, words: `mesh ${corners.size} ${[...corners].join(' ')}` });
    }
    for (const child of node.children ?? []) visit(child, world);
  };
  for (const root of json.scenes?.[json.scene ?? 0]?.nodes ?? []) visit(root, new Matrix4());
  if (parts.length === 0) throw new Error('there are no meshes in it');
  return parts;
}

function chunks(view) {
  if (view.byteLength < HEAD || view.getUint32(0, true) !== FILE) throw new Error('it is no binary glTF');
  let json = null, binary = null;
  for (let at = HEAD; at + CHUNK_HEAD <= view.byteLength;) {
    const [length, kind] = [view.getUint32(at, true), view.getUint32(at + 4, true)];
    const bytes = new Uint8Array(view.buffer, at + CHUNK_HEAD, length);
    if (kind === JSON_CHUNK) json = JSON.parse(new TextDecoder().decode(bytes));
    if (kind === BINARY_CHUNK) binary = new DataView(view.buffer, at + CHUNK_HEAD, length);
    at += CHUNK_HEAD + length;
  }
  if (!json || !binary) throw new Error('it has no text or no data in it');
  return { json, binary };
}

function matrixOf({ matrix, translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }) {
  if (matrix) return new Matrix4().fromArray(matrix);
  return new Matrix4().compose(new Vector3(...translation), new Quaternion(...rotation), new Vector3(...scale));
}

function positions(json, binary, index) {
  const accessor = json.accessors?.[index], view = json.bufferViews?.[accessor?.bufferView];
  if (!view || accessor.componentType !== FLOAT || accessor.sparse || json.buffers[view.buffer].uri)
    throw new Error('its corners are not floats in the file itself; gjk-demo play --mesh reads more');
  const from = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0), stride = view.byteStride ?? 12;
  return Array.from({ length: accessor.count }, (_, i) => (
    new Vector3(...[0, 4, 8].map((offset) => binary.getFloat32(from + i * stride + offset, true)))));
}
