// Appendix A: one cast on its way through the fast tree: which boxes and triangles it drops, step by step.
import {number, shown} from '../core/state.js';
import {bunny} from './bunny.js';

const {hand, aim, turn, tilt, radius} = bunny.parameters;

const inSixes = (list = []) => list.flatMap((each, i) => i % 6 ? [] : [[list.slice(i, i + 3), list.slice(i + 3, i + 6)]]);
const lastStep = ({step}, {drawn: {steps}}) => Math.min(step, steps);
const isOver = ({step}, {drawn: {steps}}) => step > steps;

export const fastTree = {
  program: 'general_sphere',
  asks: 'fast_tree',
  views: [{...bunny.views[0], bottom: -6.4}],
  space: {...bunny.space, opacity: 0.45},
  parameters: {step: number(1, {least: 0, most: 120, step: 1}), hand, aim, turn, tilt, radius},

  numbers: ({turn, tilt, hand, aim, radius, step}) => [turn, tilt, ...hand, ...aim, radius, step],
  options: bunny.options,
  draw: bunny.draw,

  inSpace(state, answer, space) {
    const {contact, drawn: {from, to, waiting, kept, dropped, triangles = {kept: [], dropped: []}}} = answer;
    space.ball(from, state.radius, 'amber', 0.5);
    space.arrow(from, to, 'red');
    if (contact && isOver(state, answer)) {
      space.ball(contact.center, state.radius, 'amber', 0.8);
      return space.triangle(contact.triangle, 'green');
    }
    for (const [low, high] of inSixes(waiting)) space.box(low, high, 'blue', 0.025);
    for (const [low, high] of inSixes(dropped)) space.box(low, high, 'pink', 0.02);
    for (const [low, high] of inSixes(kept)) space.box(low, high, 'green', 0.05);
    for (const each of triangles.dropped) space.triangle(each, 'pink');
    for (const each of triangles.kept) space.triangle(each, 'green');
  },

  answers: (state, answer, words) => {
    const {contact, drawn: {steps, kept = [], dropped = [], waiting = [], triangles}} = answer;
    const count = (boxes, ofLeaf) => String(triangles ? ofLeaf.length : boxes.length / 6);
    return [[words.at, [words.of(lastStep(state, answer), steps)]], [words.kept, [count(kept, triangles?.kept), 'right']],
            [words.dropped, [count(dropped, triangles?.dropped), 'printed']], [words.waiting, [String(waiting.length / 6)]],
            ['<i>t</i>', [shown(contact?.time)]], [words.triangle, [contact ? String(contact.triangle) : '–']]];
  },

  told: (state, answer, words) => {
    const {contact, drawn: {steps, kept = [], dropped = [], waiting = [], triangles}} = answer;
    if (state.step < 1) return words.begins(steps);
    if (isOver(state, answer)) return contact ? words.ends(contact.triangle, shown(contact.time)) : words.free;
    const looked = triangles ? words.leaf(triangles.kept.length, triangles.dropped.length)
      : words.node(kept.length / 6, dropped.length / 6);
    return `${words.nth(state.step, steps)} ${looked} ${words.waits(waiting.length / 6)}`;
  },
};
