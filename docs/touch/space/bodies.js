// What the figures put into space, whoever draws it: an arrow is a bar and a head, a box is twelve bars. Places are the
// library's, a colour is one of the book's, by its name.
import {along, distance, unit} from './vectors.js';

/// Light comes from behind the eye's shoulder; what is in shadow has its colour too, only darker.
export const lampOf = ({eye, up}) => unit(eye.map((each, i) => each + 0.5 * up[i]));
export const [darkest, brightest] = [0.5, 1.05];

export class Bodies {
  constructor(canvas) {
    Object.assign(this, {canvas, colours: new Map()});
  }

  /// [red, green, blue] of a colour, each to 255, in the theme that is seen; asked for once.
  colour(name) {
    if (!this.colours.has(name)) {
      this.canvas.style.color = `var(--${name})`;
      this.colours.set(name, getComputedStyle(this.canvas).color.match(/[\d.]+/g).slice(0, 3).map(Number));
    }
    return this.colours.get(name);
  }

  /// Light has become dark, or dark light.
  repaint() {
    this.colours.clear();
  }

  arrow(from, to, colour) {
    const length = distance(from, to), tip = Math.min(0.55, length);
    if (length === 0) return;
    const neck = along(to, from, tip / length);
    this.bar(from, neck, 0.05, colour);
    this.head(neck, to, 0.17, colour);
  }

  /// The edges of a box, from its lowest corner to its highest.
  box(low, high, colour, radius) {
    const corner = (i) => low.map((each, k) => i >> k & 1 ? high[k] : each);
    for (let i = 0; i < 8; ++i)
      for (const k of [1, 2, 4]) if (!(i & k)) this.bar(corner(i), corner(i | k), radius, colour);
  }
}
