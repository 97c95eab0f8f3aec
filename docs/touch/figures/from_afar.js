// Chapter 4: a ball comes from afar at a vertex: what floats make of the root as multiplied out.
import {number, shown} from '../core/state.js';

const view = {left: -4.5, right: 4.5, bottom: -1.5, top: 2.6};

// 1, 3.16, 10, ... radii, three digits each: the line that runs the same scene has the same number.
const distance = ({power}) => Number((10 ** power).toPrecision(3));
const inView = (place) => place && [Math.min(Math.max(place[0], view.left + 0.4), view.right - 0.4), place[1]];

export const fromAfar = {
  program: 'general-sphere',
  asks: 'from_afar',
  views: [view],
  parameters: {
    power: number(3.8, {least: 0.5, most: 9, step: 0.5, fine: 0.1}),
    beside: number(0.6, {least: 0, most: 1.2, step: 0.1, fine: 0.01}),
  },

  numbers: (state) => [distance(state), state.beside],
  options: (state) => ({'--afar': distance(state), '--beside': state.beside}),

  draw([pen], {beside}, {drawn}) {
    const right = drawn.double?.stable, printed = inView(drawn.float?.textbook);
    return [[
      pen.arrow([view.left, beside], [view.right - 0.3, beside], 'motion rest'), pen.ball([0, 0], 1, 'trace'),
      ...(right ? [pen.ball(right, 1, 'ball right'), pen.dot(right)] : []),
      ...(printed ? [pen.ball(printed, 1, 'printed'), pen.dot(printed, 'dot printed')] : []),
      pen.dot([0, 0], 'dot', 4), pen.label('A', [0, 0], [8, 20]),
    ]];
  },

  answers: (state, {afar}, words) => [
    [words.minusB, [shown(afar.float.minus_b)]], [words.root, [shown(afar.float.root)]],
    [words.floatPrinted, [afar.float.textbook === undefined ? words.none : shown(afar.float.textbook), 'printed']],
    [words.floatStable, [shown(afar.float.stable), 'right']],
    [words.doublePrinted, [afar.double.textbook === undefined ? words.none : shown(afar.double.textbook), 'printed']],
    [words.doubleStable, [shown(afar.double.stable), 'right']]],

  told: (state, {drawn: {apart, double}}, words) => !double?.stable ? words.misses
    : apart === undefined ? words.lost : words.apart(shown(apart)),
};
