// What is steered: a key is a step, and while its handle is held it goes on towards the pointer. A step begins where the one
// before has ended.
import {clamped} from '../core/state.js';

const inEachPicture = 0.04;  // of the way to the pointer

/// What the handle of `steered.by` does when it is moved; the steps begin at `steered.at`.
export function steering(figure) {
  const {parameters, steered: {by, at}} = figure.own;
  let towards, goes = false;
  const held = () => figure.handles.find(({name}) => name === by).held;
  const step = (wished) => {
    figure.state = {...figure.state, [at]: clamped(parameters[at], figure.answer.end), [by]: clamped(parameters[by], wished)};
    figure.changed();
  };
  const go = () => {
    goes = Boolean(held());
    if (!goes) return;
    step(towards.map((each) => inEachPicture * each));
    requestAnimationFrame(go);
  };
  return (wished) => {
    towards = wished;
    if (!held()) step(wished);
    else if (!goes) go();
  };
}
