// A figure in space: below its marks lies what three draws, and a hand on the picture turns it, or points.
import {make} from './controls.js';
import {script} from './module.js';

/// Where it is drawn, below the marks.
export const canvasBelow = () => make('canvas', {className: 'space', 'aria-hidden': true});

/// What draws it, once all that it needs is loaded; nothing where there is no WebGL.
export async function spaceOf({canvas, own: {space}}, ask) {
  const {mesh, asks} = space;
  await Promise.all([script('touch-space.js'), ...(mesh ? [script(`touch-${mesh}.js`)] : [])]);
  const context = canvas.getContext('webgl2', {antialias: true, alpha: true});
  const surface = () => mesh ? globalThis.firstContactMeshes[mesh] : ask(asks);
  return context && new globalThis.firstContactSpace.Space(canvas, context, surface(), space);
}

/// The words of a figure, where it cannot be drawn.
export function sayInstead({element, words}) {
  element.replaceChildren(make('p', {className: 'told', textContent: words.noSpace}));
}

const aPixel = 0.5;  // in degrees

/// A drag beside the handles turns what is seen; a press that stays where it is sets the place that is pointed at.
export function turnByHand(figure) {
  const {picture, own: {space: {turn, tilt, point}}} = figure;
  let held;
  picture.classList.add('turned');
  picture.addEventListener('pointerdown', (event) => {
    if (event.button > 0 || event.target.closest('.handle')) return;
    held = {x: event.clientX, y: event.clientY, turn: figure.state[turn], tilt: figure.state[tilt], moved: false};
    picture.setPointerCapture(event.pointerId);
  });
  picture.addEventListener('pointermove', ({clientX, clientY}) => {
    if (!held) return;
    const [x, y] = [clientX - held.x, clientY - held.y];
    held.moved ||= Math.hypot(x, y) > 4;
    if (!held.moved) return;
    figure.change(turn, around(held.turn - aPixel * x));
    figure.change(tilt, held.tilt + aPixel * y);
  });
  picture.addEventListener('pointerup', ({clientX, clientY}) => {
    const {left, top} = picture.getBoundingClientRect();
    const pointed = held && !held.moved;
    held = undefined;
    if (!pointed || !point) return;
    figure.change(point, figure.pens[0].world([clientX - left, clientY - top]));
    if (figure.player) figure.play(true);
  });
  picture.addEventListener('pointercancel', () => { held = undefined; });
  new MutationObserver(() => figure.show()).observe(document.documentElement, {attributeFilter: ['class']});  // light or dark
}

// From -180 to 180 degrees.
function around(degrees) {
  return degrees - 360 * Math.round(degrees / 360);
}
