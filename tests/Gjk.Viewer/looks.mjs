// What a reader would complain about in a page as it stands: text that is too pale, too small, cut off or drawn over.
/** The four ways in which every page is looked at. */
export const LOOKS = [1280, 390].flatMap((width) => ['light', 'dark'].map((theme) => ({ width, theme })));

/** The faults of a page, one sentence each. It runs in the page, so it may name nothing outside itself. */
export function faultsOfLook() {
  const MIN_CONTRAST = 4.5, MIN_PIXELS = 11, FEW = 2, PEN = 6;
  const faults = new Set();
  const canvas = document.createElementNS('http://www.w3.org/1999/xhtml', 'canvas');
  const pen = canvas.getContext('2d', { willReadFrequently: true });
  const colors = new Map();
  check(document);
  return [...faults];

  function check(root) {
    const page = root.documentElement, seen = new Map();
    if (page.scrollWidth > page.clientWidth + 1)
      faults.add(`the page is ${page.scrollWidth} wide in ${page.clientWidth}`);
    const texts = root.createTreeWalker(root.body ?? page, NodeFilter.SHOW_TEXT);
    while (texts.nextNode()) {
      const node = texts.currentNode, element = node.parentElement;
      if (!node.data.trim() || !isSeen(element)) continue;
      if (!seen.has(element)) seen.set(element, node.data.trim().slice(0, 40));
    }
    for (const [element, text] of seen) {
      const pixels = sizeOf(element);
      if (pixels < MIN_PIXELS - 0.05) faults.add(`${pixels.toFixed(1)} px: ${where(element)} "${text}"`);
      const contrast = contrastOf(element);
      if (contrast < MIN_CONTRAST - 0.05) faults.add(`contrast ${contrast.toFixed(2)}: ${where(element)} "${text}"`);
      const box = clipperOf(element);
      if (box) faults.add(`cut off, ${box.scrollWidth} by ${box.scrollHeight}: ${where(box)} "${text}"`);
    }
    for (const svg of root.querySelectorAll('svg')) labels(svg);
    apart([...root.querySelectorAll('.label')].filter(isSeen));
    for (const image of root.querySelectorAll('img'))
      if (image.getBoundingClientRect().right > page.clientWidth + 1)
        faults.add(`an image is wider than the page: ${image.src}`);
  }

  /** The labels of a drawing lie on nothing: not on each other, on no line, on no body that hides what is below. */
  function labels(svg) {
    const all = [...svg.querySelectorAll('text')].filter((t) => t.textContent.trim() && isSeen(t));
    apart(all);
    const frame = svg.getBoundingClientRect();
    for (const label of all) {
      const box = inkOf(label), name = label.textContent.trim();
      if (box.left < frame.left - 1 || box.right > frame.right + 1
        || box.top < frame.top - 1 || box.bottom > frame.bottom + 1)
        faults.add(`a label leaves its picture: "${name}"`);
      for (const body of svg.querySelectorAll('path, circle, line, polygon, polyline, ellipse')) {
        const near = body.getBoundingClientRect();
        if (near.left > box.right + PEN || near.right < box.left - PEN
          || near.top > box.bottom + PEN || near.bottom < box.top - PEN) continue;
        if (body.closest('defs, pattern, marker') || !body.checkVisibility({ visibilityProperty: true })) continue;
        const style = getComputedStyle(body);
        const isFilled = /^rgb/.test(style.fill) && rgba(style.fill)[3] * style.fillOpacity * style.opacity > 0.5;
        // The hairlines of a grid or of axes may pass below a label, which has a halo.
        const isDrawn = style.stroke !== 'none' && parseFloat(style.strokeWidth) > 1
          && style.strokeOpacity * style.opacity > 0.2;
        const toBody = body.getScreenCTM()?.inverse();
        if (!toBody || !(isFilled || isDrawn)) continue;
        let hits = 0;
        const step = 2;
        for (let x = box.left + 1; x < box.right; x += step) for (let y = box.top + 1; y < box.bottom; y += step) {
          const point = new DOMPoint(x, y).matrixTransform(toBody);
          if (isFilled && body.isPointInFill(point) || isDrawn && body.isPointInStroke(point)) hits++;
        }
        if (hits > FEW) faults.add(`the label "${name}" lies on ${where(body)}, ${hits} points of it`);
      }
    }
  }

  function apart(all) {
    const boxes = all.map(inkOf);
    for (let i = 0; i < all.length; i++) for (let j = 0; j < i; j++) {
      const [a, b] = [boxes[i], boxes[j]];
      if (a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1)
        faults.add(`the labels "${all[j].textContent.trim()}" and "${all[i].textContent.trim()}" overlap`);
    }
  }

  /** The box of a label without the empty space above and below its letters. */
  function inkOf(label) {
    const box = label.getBoundingClientRect(), spare = 0.2 * box.height;
    return new DOMRect(box.x, box.y + spare, box.width, box.height - 1.6 * spare);
  }

  function isSeen(element) {
    if (!element.checkVisibility({ opacityProperty: true, visibilityProperty: true })) return false;
    if (element.closest('script, style, title, noscript, template, .unseen, .visually-hidden, :disabled')) return false;
    const box = element.getBoundingClientRect();
    return box.width > 1 && box.height > 1 && box.right > 0 && box.left < innerWidth;
  }

  function sizeOf(element) {
    const pixels = parseFloat(getComputedStyle(element).fontSize), matrix = element.getScreenCTM?.();
    return matrix ? pixels * Math.sqrt(Math.abs(matrix.a * matrix.d - matrix.b * matrix.c)) : pixels;
  }

  function clipperOf(element) {
    for (let box = element; box && box !== document.body; box = box.parentElement) {
      const style = getComputedStyle(box);
      // What is shortened says all of it when it is pointed at.
      if (style.position === 'fixed' || box.title && style.textOverflow === 'ellipsis') return null;
      if (/auto|scroll/.test(style.overflowX + style.overflowY)) return null;
      const isWide = /hidden|clip/.test(style.overflowX) && box.scrollWidth > box.clientWidth + 1;
      const isHigh = /hidden|clip/.test(style.overflowY) && box.scrollHeight > box.clientHeight + 3;
      if (box.clientWidth > 1 && (isWide || isHigh)) return box;
    }
    return null;
  }

  function contrastOf(element) {
    const style = getComputedStyle(element), isDrawn = Boolean(element.closest('svg')) && element.tagName !== 'svg';
    let alpha = 1;
    const layers = [];
    for (let box = element; box; box = box.parentElement) {
      const own = getComputedStyle(box);
      alpha *= own.opacity;
      layers.push(rgba(own.backgroundColor));
      if (box.tagName === 'svg') {
        const paper = box.querySelector(':scope > rect');
        if (paper?.getBoundingClientRect().width > 0.9 * box.getBoundingClientRect().width)
          layers.push(rgba(getComputedStyle(paper).fill));
      }
      if (layers.at(-1)[3] === 1) break;
    }
    const back = layers.reduceRight((below, layer) => over(layer, below), isDark() ? [0, 0, 0, 1] : [255, 255, 255, 1]);
    const ink = rgba(isDrawn ? style.fill : style.color);
    const [a, b] = [lightness(over([...ink.slice(0, 3), ink[3] * alpha], back)), lightness(back)];
    return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  }

  function isDark() {
    return matchMedia('(prefers-color-scheme: dark)').matches;
  }

  function rgba(color) {
    if (!colors.has(color)) {
      pen.clearRect(0, 0, 1, 1);
      pen.fillStyle = '#000';
      pen.fillStyle = color;
      pen.fillRect(0, 0, 1, 1);
      const [r, g, b, a] = pen.getImageData(0, 0, 1, 1).data;
      colors.set(color, [r, g, b, a / 255]);
    }
    return colors.get(color);
  }

  function over([r, g, b, a], below) {
    return [...[r, g, b].map((value, i) => a * value + (1 - a) * below[i]), 1];
  }

  function lightness([r, g, b]) {
    const [x, y, z] = [r, g, b].map((v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * x + 0.7152 * y + 0.0722 * z;
  }

  function where(element) {
    return element.tagName.toLowerCase() + (element.classList.length ? `.${[...element.classList].join('.')}` : '');
  }
}
