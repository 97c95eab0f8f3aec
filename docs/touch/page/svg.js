// Drawing: a pen that knows how the world lies on the paper. What a mark means is its class, and that gives its colour
// (touch.css): mover, obstacle, motion, normal, offset, right, printed.

const names = 'http://www.w3.org/2000/svg';

/// An SVG element with its attributes and children.
export function mark(name, attributes = {}, ...children) {
  const element = document.createElementNS(names, name);
  for (const [key, value] of Object.entries(attributes)) if (value !== undefined) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

// "S_0" as S with a small 0 below; letters are italic, as in the text, and "*V*" is bold.
function letters(text) {
  const bold = /^\*(.*)\*$/.exec(text), [main, below] = (bold ? bold[1] : text).split('_');
  const parts = [mark('tspan', {class: bold ? 'vector' : 'letter'}, main)];
  if (below) parts.push(mark('tspan', {class: 'below', dy: '.28em'}, below));
  return parts;
}

/// A pen for a view {left, right, bottom, top} that is drawn `width` pixels wide, its upper left corner at `corner`. A
/// chart, whose axes have units of their own, is `tall` times as high as it is wide.
export class Pen {
  constructor(view, width, corner = [0, 0]) {
    Object.assign(this, {view, width, corner, scale: width / (view.right - view.left)});
    this.height = view.tall ? view.tall * width : (view.top - view.bottom) * this.scale;
    this.upward = this.height / (view.top - view.bottom);
  }

//! [pen]
  at([x, y]) {
    const {corner, view, scale, upward} = this;
    return [corner[0] + (x - view.left) * scale, corner[1] + (view.top - y) * upward];
  }

  /// From the paper back to the world.
  world([x, y]) {
    const {corner, view, scale, upward} = this;
    return [view.left + (x - corner[0]) / scale, view.top - (y - corner[1]) / upward];
  }
//! [pen]

  /// What is drawn in this view; nothing goes beyond its edge.
  frame(marks) {
    const [x, y] = this.corner, {width, height} = this;
    return mark('svg', {x, y, width, height, viewBox: `${x} ${y} ${width} ${height}`}, ...marks);
  }

  ball(center, radius, kind) {
    const [cx, cy] = this.at(center);
    return mark('circle', {cx, cy, r: Math.abs(radius) * this.scale, class: kind});
  }

  dot(place, kind = 'dot', r = 3.2) {
    const [cx, cy] = this.at(place);
    return mark('circle', {cx, cy, r, class: kind});
  }

  path(places, kind, closed = false) {
    const corners = places.map((place) => this.at(place).map((each) => each.toFixed(2)).join(','));
    return mark('path', {d: 'M' + corners.join('L') + (closed ? 'z' : ''), class: kind});
  }

  line(from, to, kind) {
    return this.path([from, to], kind);
  }

  arrow(from, to, kind) {
    const [a, b] = [this.at(from), this.at(to)], length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (length < 1) return mark('g');
    const [ux, uy] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length], head = Math.min(13, length);
    const side = (across) => [b[0] - head * ux - across * uy, b[1] - head * uy + across * ux].join(',');
    return mark('g', {class: `arrow ${kind}`},
                mark('path', {d: `M${a}L${b[0] - 0.8 * head * ux},${b[1] - 0.8 * head * uy}`}),
                mark('path', {class: 'head', d: `M${b}L${side(4.2)}L${side(-4.2)}z`}));
  }

  /// The name of a view, in its upper left corner.
  caption(text) {
    return mark('text', {x: this.corner[0], y: this.corner[1] + 16, class: 'view'}, text);
  }

  /// Words at a place.
  words(text, place, [dx, dy] = [0, 0], kind = 'words', anchor = 'start') {
    const [x, y] = this.at(place);
    return mark('text', {x: x + dx, y: y + dy, class: kind, 'text-anchor': anchor}, text);
  }

  /// Axes through the origin, with a number at each tic.
  axes(xs, ys) {
    return [this.path([[xs[0], ys.at(-1)], [xs[0], ys[0]], [xs.at(-1), ys[0]]], 'axis'),
            ...xs.map((x) => this.words(x, [x, ys[0]], [0, 17], 'tic', 'middle')),
            ...ys.slice(1).map((y) => this.words(y, [xs[0], y], [-5, 4], 'tic', 'end'))];
  }

  /// Letters beside a place, moved by pixels on the paper.
  label(text, place, [dx, dy] = [0, 0], kind = '', anchor = 'start') {
    const [x, y] = this.at(place);
    return mark('text', {x: x + dx, y: y + dy, class: kind, 'text-anchor': anchor}, ...letters(text));
  }
}

/// A pen for each view: beside each other, or, where the page is narrow, one below the other.
export function pensFor(views, width) {
  const inOneRow = width >= 560 || views.length === 1, gap = 24, pens = [];
  const each = inOneRow ? (width - gap * (views.length - 1)) / views.length : width;
  let corner = [0, 0];
  for (const view of views) {
    const pen = new Pen(view, each, corner);
    corner = inOneRow ? [corner[0] + each + gap, 0] : [0, corner[1] + pen.height + gap];
    pens.push(pen);
  }
  return pens;
}
