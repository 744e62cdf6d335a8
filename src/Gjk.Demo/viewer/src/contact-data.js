import { bytes, floats } from './data.js';

/** Numbers in a point: A's point, then the gap. */
const POINT = 4;

/** The count of a pair whose points the page does not hold, because it has too many. */
const LEFT_OUT = 255;

/**
 * The contact points of the pairs that overlap, in the order of the frames and then of the pairs. Pairs that are apart
 * have no entry.
 */
export class ContactData {
  constructor(json, overlapping) {
    this.counts = bytes(json.contactCounts);
    this.points = floats(json.contactPoints);
    this.frames = [];
    this.most = 1;
    let entry = 0,
      point = 0;
    for (const pairs of overlapping) {
      this.frames.push({ entry, point });
      const first = point;
      for (const end = entry + pairs; entry < end; entry++) point += kept(this.counts[entry]);
      this.most = Math.max(this.most, point - first);
    }
  }

  /** Goes to a frame, whose overlapping pairs must then be given in their order. */
  begin(frame, pairs) {
    ({ entry: this.entry, point: this.point } = this.frames[frame]);
    this.first = new Int32Array(pairs);
    this.count = new Uint8Array(pairs);
  }

  next(pair) {
    this.first[pair] = this.point;
    this.count[pair] = this.counts[this.entry++];
    this.point += kept(this.count[pair]);
  }

  isLeftOut(pair) {
    return this.count[pair] === LEFT_OUT;
  }

  /** The points of a pair, each as [x, y, z, gap]. */
  of(pair) {
    return Array.from({ length: kept(this.count[pair]) }, (_, i) => {
      const at = POINT * (this.first[pair] + i);
      return Array.from(this.points.subarray(at, at + POINT));
    });
  }
}

const kept = (count) => (count === LEFT_OUT ? 0 : count);
