// What can be moved: by a pointer, a finger or the keys. A handle is a slider to who cannot see it, and says its place.
import {mark} from './svg.js';

// As sliders have it: a page is ten steps, and an end is beyond all steps.
const ways = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
  PageUp: [0, 10], PageDown: [0, -10], Home: [-1e6, 0], End: [1e6, 0]};

/// The way that a key asks for, in steps of a parameter: [x, y], or nothing.
export function wayOf(event, {step, fine}) {
  const way = ways[event.key];
  return way && !event.altKey && !event.ctrlKey && !event.metaKey && way.map((each) => each * (event.shiftKey ? fine : step));
}

/// Where a pointer is on the picture, in its own pixels.
function placeOf(event, picture) {
  const box = picture.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

/// A handle for one place of the state.
/// \param now  its place, [x, y] in the world; \param moved  called with the wished one
export class Handle {
  constructor(name, parameter, label, now, moved) {
    Object.assign(this, {name, parameter, now, moved});
    const {least, most, start} = parameter;
    const range = {'aria-valuemin': least[0], 'aria-valuemax': most[0], 'aria-valuenow': start[0]};
    this.isLevel = least[1] === most[1];  // it can be moved along a line alone
    this.element = mark('g', {class: 'handle', tabindex: 0, role: 'slider', 'aria-label': label, ...range},
                        mark('circle', {class: 'reach', r: 22}), mark('circle', {class: 'ring', r: 9}));
    this.element.addEventListener('touchstart', (event) => event.preventDefault(), {passive: false});  // no scrolling
    this.element.addEventListener('pointerdown', (event) => this.grab(event));
    this.element.addEventListener('pointermove', (event) => this.drag(event));
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'])
      this.element.addEventListener(end, ({pointerId}) => { if (pointerId === this.held?.pointer) this.held = undefined; });
    this.element.addEventListener('keydown', (event) => this.key(event));
  }

//! [drag]
  grab(event) {
    if (event.button > 0 || this.held) return;  // the first finger has it
    event.preventDefault();
    this.element.focus({preventScroll: true});
    this.element.setPointerCapture(event.pointerId);
    const at = placeOf(event, this.element.ownerSVGElement), own = this.pen.at(this.now());
    // A handle that is caught at its rim does not jump.
    this.held = {pointer: event.pointerId, beside: [own[0] - at[0], own[1] - at[1]]};
  }

  drag(event) {
    if (event.pointerId !== this.held?.pointer) return;
    const at = placeOf(event, this.element.ownerSVGElement), {beside} = this.held;
    this.moved(this.pen.world([at[0] + beside[0], at[1] + beside[1]]));
  }
//! [drag]

  key(event) {
    const way = wayOf(event, this.parameter);
    if (!way) return;
    event.preventDefault();
    const [x, y] = this.now();
    this.moved(this.isLevel ? [x + way[0] + way[1], y] : [x + way[0], y + way[1]]);
  }

  /// Puts the handle where the state has it.
  show(pen, value, words) {
    this.pen = pen;
    const [x, y] = pen.at(this.now());
    this.element.setAttribute('transform', `translate(${x},${y})`);
    this.element.setAttribute('aria-valuenow', value[0]);
    this.element.setAttribute('aria-valuetext', words);
  }
}
