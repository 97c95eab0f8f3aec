// A figure to touch: its state, what the book's C++ answers, and one function, `show`, that draws all of it anew.
import {showAnswers} from '../page/controls.js';
import {layOut} from '../page/layout.js';
import {pensFor} from '../page/svg.js';
import {turnByHand} from '../space/space.js';
import {clamped, fragmentOf, shown, startOf, stateFrom} from './state.js';

// Does something once, a while after it was last asked for.
function later(milliseconds, what) {
  let timer;
  return () => {
    clearTimeout(timer);
    timer = setTimeout(what, milliseconds);
  };
}

export class Figure {
  /// \param element  the page's place for it
  /// \param own  what this figure is: figures/*.js
  /// \param words  its words, and those of all figures: words/*.js
  /// \param announce  says something aloud, once
  constructor(element, own, words, announce) {
    Object.assign(this, {element, own, words, announce, id: element.id, state: startOf(own.parameters)});
    this.tell = later(500, () => announce(this.told.textContent));
    this.keep = later(300, () => history.replaceState(null, '', fragmentOf(this.id, this.state)));
    layOut(this);
    addEventListener('hashchange', () => this.follow());
  }

  /// Begins to answer, once the book's C++ is there.
  begin(ask) {
    this.ask = ask;
    if (this.own.space) turnByHand(this);
    this.follow();
    new ResizeObserver(() => this.show()).observe(this.picture);
    this.show();
  }

  // The state that the address asks for, if it asks this figure.
  follow() {
    const state = stateFrom(location.hash, this.id, this.own.parameters);
    if (!state || !this.ask) return;
    this.stop();
    this.state = state;
    this.show();
    this.element.scrollIntoView({block: 'center'});
  }

  // Where a place is counted from, and in which units: a way begins at another place.
  frameOf(name) {
    const {from = [0, 0], frame} = this.own.parameters[name];
    return frame ? frame(this.state) : {base: Array.isArray(from) ? from : this.state[from], unit: [1, 1]};
  }

  // Where a handle is, or what a slider shows.
  shownPlace(name) {
    if (name === this.own.steered?.by) return [0, 0];  // it stands in the middle of its picture
    const value = this.state[name];
    if (!Array.isArray(value)) return value;
    const {base, unit} = this.frameOf(name);
    return value.map((each, i) => base[i] + unit[i] * each);
  }

  // What is meant by moving it there.
  meant(name, wished) {
    if (!Array.isArray(wished)) return wished;
    const {base, unit} = this.frameOf(name);
    return wished.map((each, i) => (each - base[i]) / unit[i]);
  }

//! [change]
  change(name, wished) {
    const value = clamped(this.own.parameters[name], wished);
    if (String(value) === String(this.state[name])) return;
    this.state = {...this.state, [name]: value};
    this.changed();
  }

  changed() {
    this.keep();
    this.soon ??= requestAnimationFrame(() => {
      this.soon = undefined;
      this.show();
      this.tell();
    });
  }
//! [change]

  /// Lets one number run from its least value to its most, in so many seconds.
  play(on) {
    const {of, seconds} = this.own.play, {least, most} = this.own.parameters[of];
    const run = this.playing = on && {};
    this.player.textContent = on ? this.words.pause : this.words.play;
    if (!on) return;
    const first = this.state[of] < most ? this.state[of] : least, begun = performance.now();
    const step = () => {
      if (this.playing !== run) return;
      const value = first + (performance.now() - begun) / 1000 / seconds * (most - least);
      this.change(of, value);
      if (value < most) requestAnimationFrame(step);
      else this.play(false);
    };
    step();
  }

  stop() {
    if (this.playing) this.play(false);
  }

//! [show]
  /// The one function that asks and draws.
  show() {
    const width = this.picture.clientWidth, {own, state} = this;
    if (!width || !this.ask) return;
    this.answer = this.ask(own.asks ?? own.program, ...own.numbers(state));
    const pens = this.pens = pensFor(own.views, width), last = pens.at(-1);
    const height = Math.ceil(last.corner[1] + last.height);
    this.picture.setAttribute('viewBox', `0 0 ${width} ${height}`);
    this.picture.style.height = `${height}px`;
    for (const slider of this.sliders) slider.show(state[slider.name]);
    for (const handle of this.handles)
      handle.show(pens[handle.parameter.view], state[handle.name], this.said(handle.name));
    this.link.href = fragmentOf(this.id, state);
    this.line.textContent = this.command();
    this.told.innerHTML = this.answer.refused ?? own.told(state, this.answer, this.words);
    if (this.answer.refused) return;
    const drawn = own.draw(pens, state, this.answer, this.words);
    this.drawing.replaceChildren(...drawn.map((marks, i) => pens[i].frame(marks)));
    this.space?.show(pens[0], this.answer.drawn.view, (space) => own.inSpace(state, this.answer, space));
    const took = own.measure?.(this.ask, state, this.answer);
    showAnswers(this.answers, own.answers(state, this.answer, this.words, took));
  }
//! [show]

  // Where a handle is, in words.
  said(name) {
    const {said, place} = this.words;
    return (said?.[name] ?? place)(...this.state[name].map(shown));
  }

  /// The line that runs the same scene; where a value begins with a minus, it is joined by =.
  command() {
    const options = Object.entries(this.own.options(this.state, this.answer)).map(([name, value]) => {
      const text = String(value);
      return `${name}${text.startsWith('-') ? '=' : ' '}${text}`;
    });
    return ['./course run', this.own.program.replaceAll('-', '_'), ...options].join(' ');
  }
}
