// What stands below a picture: a slider for each number, the answers, buttons, and the line that runs the same scene.
import {wayOf} from './handles.js';
import {shown} from '../core/state.js';

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
/// \param now  what it is; \param moved  called with what is wished
export class Slider {
  constructor(name, parameter, label, now, moved) {
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
      moved(now() + way[0] + way[1]);
    });
  }

  show(value) {
    this.input.value = value;
    this.output.textContent = shown(value);
    this.input.setAttribute('aria-valuetext', shown(value));
  }
}

/// A box to be ticked, for what is on or off.
export class Toggle {
  constructor(name, parameter, label, now, moved) {
    this.name = name;
    this.input = make('input', {type: 'checkbox', 'aria-label': label.spoken});
    this.element = make('label', {className: 'toggle'}, this.input, make('span', {innerHTML: label.html}));
    this.input.addEventListener('change', () => moved(Number(this.input.checked)));
  }

  show(value) {
    this.input.checked = value === 1;
  }
}

/// Buttons of which one is pressed in: one of several.
export class Choice {
  constructor(name, parameter, label, now, moved) {
    this.name = name;
    this.inputs = label.choices.map((spoken, i) => {
      const input = make('input', {type: 'radio', name: `choice-${name}`, 'aria-label': spoken});
      input.addEventListener('change', () => moved(i));
      return input;
    });
    this.element = make('div', {className: 'choice', role: 'radiogroup', 'aria-label': label.spoken},
                        ...this.inputs.map((input, i) =>
                          make('label', {className: 'toggle'}, input, make('span', {textContent: label.choices[i]}))));
  }

  show(value) {
    this.inputs.forEach((input, i) => { input.checked = i === value; });
  }
}

function answer([text, kind = '', part]) {
  const element = make('dd', {textContent: text, className: kind});
  if (part !== undefined) element.append(make('span', {className: 'bar', style: `--part: ${part}`}));
  return element;
}

/// Numbers with their names, live: each row is a name, as HTML, and its answers, [text, kind, part of a bar from 0 to 1].
export function showAnswers(list, rows) {
  list.replaceChildren(...rows.map(([name, ...answers]) =>
    make('div', {}, make('dt', {innerHTML: name}), ...answers.map(answer))));
}

/// A button.
export const button = (label, pressed) => {
  const element = make('button', {type: 'button', textContent: label});
  element.addEventListener('click', pressed);
  return element;
};
