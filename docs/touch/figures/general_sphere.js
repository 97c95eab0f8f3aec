// Chapter 4: a ball against a solid with corners: its surface moved out, the feature met first, and the paper's cylinders.
import {flat, pairs} from '../core/lists.js';
import {number, place, shown} from '../core/state.js';

const view = {left: -3.7, right: 3.9, bottom: -2.1, top: 2.9};
const anywhere = {least: [-3.2, -2], most: [3.2, 2.8]};

// The side or the corner that is touched; of each side there are two triangles.
function touched(pen, corners, {feature, triangle, point}) {
  if (feature !== 'face') return pen.dot(flat(point), 'lit', 6);
  const side = Math.floor(triangle / 2);
  return pen.line(corners[side], corners[(side + 1) % corners.length], 'lit');
}

// Moved out by the radius: the outline with a pen as wide as the ball.
function movedOut(pen, corners, radius) {
  const wide = 2 * radius * pen.scale;
  return [['offset-edge', wide + 2.4], ['offset-inside', wide]].map(([kind, width]) => {
    const outline = pen.path(corners, kind, true);
    outline.style.strokeWidth = width;
    return outline;
  });
}

export const generalSphere = {
  program: 'general_sphere',
  views: [view],
  parameters: {
    from: place([2.9, 1.6], anywhere),
    to: place([0.8, 0], anywhere),
    radius: number(0.45, {least: 0, most: 0.9, step: 0.05, fine: 0.01}),
  },

  numbers: ({from, to, radius}) => [...from, ...to, radius],
  options: ({from, to, radius}) => ({
    '--solid': 'prism', '--from': [from[0], 0, from[1]], '--to': [to[0], 0, to[1]], '--radius': radius}),

  draw([pen], {from, to, radius}, {contact, printed_time: printed, drawn}) {
    const corners = pairs(drawn.section);
    const met = contact ? [
      touched(pen, corners, contact), pen.ball(flat(contact.center), radius, 'mover there'),
      pen.arrow(from, flat(contact.center), 'motion'), pen.dot(flat(contact.point)),
      pen.label('C', flat(contact.point), [-18, 16])] : [];
    const stopped = printed === undefined ? [] : [pen.ball(flat(drawn.stopped), radius, 'printed')];
    return [[
      ...movedOut(pen, corners, radius), pen.path(corners, 'solid', true),
      ...pairs(drawn.axes).map((axis) => pen.ball(axis, radius, 'printed thin-circle')),
      pen.ball(from, radius, 'mover'), pen.arrow(from, to, 'motion rest'), ...stopped, ...met,
      pen.label('S_0', from, [12, -12]), pen.label('S_1', to, [12, 18]),
    ]];
  },

  answers: (state, {contact, printed_time: printed}, words) => [
    ['<i>t</i>', [shown(contact?.time), 'right']], [words.feature, [contact ? words[contact.feature] : '–', 'right']],
    ['<i>C</i>', [contact ? `(${flat(contact.point).map(shown).join(', ')})` : '–']],
    [words.cylinder, [shown(printed), 'printed']]],

  told: (state, {contact, printed_time: printed}, words) => [
    contact ? words.touches(words[contact.feature], shown(contact.time)) : words.free,
    printed === undefined ? words.noCylinder : words.stops(shown(printed))].join(' '),
};
