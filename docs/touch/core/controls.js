// What stands below a picture: a slider for each number, the answers, buttons, and the line that runs the same scene.
import {wayOf} from './handles.js';
import {shown} from './state.js';

/// An element of the page; properties beginning with aria- or data- are attributes.
export function make(name, properties = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(properties))
    if (key.includes('-')) element.setAttribute(key, value);
    else element[key] = value;
  element.append(...children);
  return element;
}

/// A slider for one number of the state.
export class Slider {
  constructor(name, parameter, label, moved) {
    this.name = name;
    const {least, most, step, fine} = parameter;
    this.output = make('output');
    this.input = make('input', {type: 'range', min: least, max: most, step: fine, 'aria-label': label.spoken});
    this.element = make('label', {className: 'slider'}, make('span', {innerHTML: label.html}), this.input, this.output);
    this.input.addEventListener('input', () => moved(this.input.valueAsNumber));
    this.input.addEventListener('keydown', (event) => {
      const way = wayOf(event, {step, fine});
      if (!way) return;
      event.preventDefault();
      moved(this.value + way[0] + way[1]);
    });
  }

  show(value) {
    this.value = value;
    this.input.value = value;
    this.output.textContent = shown(value);
    this.input.setAttribute('aria-valuetext', shown(value));
  }
}

/// Numbers with their names, live: the rows are [letter as HTML, text, kind].
export function showAnswers(list, rows) {
  list.replaceChildren(...rows.map(([letter, text, kind = '']) =>
    make('div', {className: kind}, make('dt', {innerHTML: letter}), make('dd', {textContent: text}))));
}

/// A button.
export const button = (label, pressed) => {
  const element = make('button', {type: 'button', textContent: label});
  element.addEventListener('click', pressed);
  return element;
};
