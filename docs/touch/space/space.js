// A figure in space: below its marks lies what is drawn in space, and a hand on the picture turns it, or points.
import {script} from '../core/module.js';
import {make} from '../page/controls.js';
import {Flat} from './flat.js';

/// Where it is drawn, below the marks.
export const canvasBelow = () => make('canvas', {className: 'space', 'aria-hidden': true});

// Is there a graphics card that draws? What a processor does in its place has a name, and takes too long for a drag.
function hasGraphics() {
  const context = document.createElement('canvas').getContext('webgl2');
  if (!context) return false;
  const names = context.getExtension('WEBGL_debug_renderer_info');
  const name = context.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER);
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return !/SwiftShader|llvmpipe|softpipe|Software|Basic Render/i.test(name);
}

/// What draws it: three, or without a graphics card a painter upon a flat canvas.
export async function spaceOf({canvas, own: {space}}, ask) {
  const {mesh, asks} = space, surface = mesh ? globalThis.firstContactMeshes[mesh] : ask(asks);
  if (!hasGraphics()) return new Flat(canvas, surface, space);
  await script('touch-space.js');
  return new globalThis.firstContactSpace.Space(canvas, surface, space);
}

const aPixel = 0.5;  // in degrees

/// A drag beside the handles turns what is seen; a press that stays where it is sets the place that is pointed at.
export function turnByHand(figure) {
  const {picture, own: {space: {turn, tilt, point}}} = figure;
  let held;
  picture.classList.add('turned');
  picture.addEventListener('pointerdown', (event) => {
    if (held || event.button > 0 || event.target.closest('.handle')) return;
    const {pointerId: pointer, clientX: x, clientY: y} = event;
    held = {pointer, x, y, turn: figure.state[turn], tilt: figure.state[tilt], moved: false};
    picture.setPointerCapture(event.pointerId);
  });
  picture.addEventListener('pointermove', ({clientX, clientY, pointerId}) => {
    if (pointerId !== held?.pointer) return;
    const [x, y] = [clientX - held.x, clientY - held.y];
    held.moved ||= Math.hypot(x, y) > 4;
    if (!held.moved) return;
    figure.change(turn, around(held.turn - aPixel * x));
    figure.change(tilt, held.tilt + aPixel * y);
  });
  picture.addEventListener('pointerup', ({clientX, clientY, pointerId}) => {
    if (pointerId !== held?.pointer) return;
    const {left, top} = picture.getBoundingClientRect();
    const pointed = !held.moved;
    held = undefined;
    if (!pointed || !point) return;
    figure.change(point, figure.pens[0].world([clientX - left, clientY - top]));
    if (figure.player) figure.play(true);
  });
  picture.addEventListener('pointercancel', ({pointerId}) => { if (pointerId === held?.pointer) held = undefined; });
  const repaint = () => { figure.space?.repaint(); figure.show(); };
  new MutationObserver(repaint).observe(document.documentElement, {attributeFilter: ['class']});  // light or dark
}

// From -180 to 180 degrees.
function around(degrees) {
  return degrees - 360 * Math.round(degrees / 360);
}
