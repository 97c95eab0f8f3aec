// How a figure stands on the page: its picture, and below that the answers, what may be set, what is told in words, and the
// line that runs the same scene.
import {startOf} from '../core/state.js';
import {canvasBelow} from '../space/space.js';
import {Choice, Slider, Toggle, button, make} from './controls.js';
import {Handle} from './handles.js';
import {steering} from './steer.js';
import {mark} from './svg.js';

const calm = matchMedia('(prefers-reduced-motion: reduce)');

// What is ticked or chosen has its own control.
const kindOf = ({isToggle, isChoice}) => isToggle ? Toggle : isChoice ? Choice : undefined;

// What is done when a control wishes for a value.
function movedBy(figure, name) {
  const {own} = figure;
  if (name === own.steered?.by) return steering(figure);
  return (wished) => {
    if (name === own.play?.of) figure.stop();
    figure.change(name, figure.meant(name, wished));
  };
}

// A control for each parameter that is a place, or for each that is not.
function controlsOf(figure, Kind, wanted) {
  return Object.entries(figure.own.parameters)
      .filter(([, {isPlace = false, isExact}]) => !isExact && isPlace === wanted)
      .map(([name, parameter]) => new (kindOf(parameter) ?? Kind)(
        name, parameter, figure.words[name], () => figure.shownPlace(name), movedBy(figure, name)));
}

// A cross-hair follows the pointer, and the right button sets a place of the state there (paper, 2.4.3).
function aim(figure, name) {
  const {picture} = figure, hair = mark('path', {class: 'hair', 'aria-hidden': true});
  picture.append(hair);
  const at = ({clientX, clientY}) => {
    const {left, top} = picture.getBoundingClientRect();
    return [clientX - left, clientY - top];
  };
  picture.addEventListener('pointermove', (event) => {
    const [x, y] = at(event), [{width, height}] = figure.pens;
    hair.setAttribute('d', `M${x},0V${height}M0,${y}H${width}`);
  });
  picture.addEventListener('pointerleave', () => hair.removeAttribute('d'));
  picture.addEventListener('contextmenu', (event) => {
    event.preventDefault();
    figure.change(name, figure.pens[0].world(at(event)));
  });
}

function buttonsOf(figure) {
  const {own, words} = figure;
  const reset = button(words.reset, () => { figure.stop(); figure.state = startOf(own.parameters); figure.changed(); });
  if (!own.play || calm.matches) return [reset];
  figure.player = button(words.play, () => figure.play(!figure.playing));
  return [figure.player, reset];
}

/// Gives a figure its handles, its sliders, and all that stands on the page.
export function layOut(figure) {
  const {element, id, own, words} = figure, elements = (controls) => controls.map((each) => each.element);
  figure.handles = controlsOf(figure, Handle, true);
  figure.sliders = controlsOf(figure, Slider, false);
  figure.drawing = mark('g', {'aria-hidden': true});
  figure.picture = mark('svg', {role: 'group', 'aria-label': words.title, 'aria-describedby': `${id}-told`},
                        figure.drawing, ...elements(figure.handles));
  if (own.rightButton) aim(figure, own.rightButton);
  if (own.space) figure.canvas = canvasBelow();
  figure.answers = make('dl', {className: 'answers'});
  figure.told = make('p', {className: 'told', id: `${id}-told`});
  figure.link = make('a', {textContent: words.link});
  figure.line = make('code');
  element.replaceChildren(
    make('div', {className: 'picture'}, ...(figure.canvas ? [figure.canvas] : []), figure.picture), figure.answers,
    make('div', {className: 'sliders'}, ...elements(figure.sliders)),
    make('div', {className: 'buttons'}, ...buttonsOf(figure), figure.link), figure.told,
    make('details', {}, make('summary', {textContent: words.run}),
         make('pre', {className: 'shell', tabIndex: 0}, figure.line)),
    make('figcaption', {innerHTML: words.caption}));
  element.hidden = false;
}
