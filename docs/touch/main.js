// Finds the places for figures to touch on the page, and lets each begin when it comes near.
import {make} from './core/controls.js';
import {Figure} from './core/figure.js';
import {book} from './core/module.js';
import {sayInstead, spaceOf} from './core/space.js';
import * as figures from './figures/all.js';
import './touch.css';
import {words} from './words/en.js';

const announcer = make('div', {className: 'aloud', 'aria-live': 'polite'});
const announce = (text) => { announcer.textContent = text; };

async function begin(figure) {
  performance.mark('touch-begin');
  const ask = await book(), space = figure.own.space && await spaceOf(figure, ask);
  if (space === null) return sayInstead(figure);
  figure.begin(ask, space);
  performance.measure('touch-first-answer', 'touch-begin');
}

const near = new IntersectionObserver((seen) => {
  for (const {target, isIntersecting} of seen) {
    if (!isIntersecting) continue;
    near.unobserve(target);
    begin(target.figure);
  }
}, {rootMargin: '800px'});

document.body.append(announcer);
for (const element of document.querySelectorAll('figure.touch')) {
  const name = element.dataset.figure;
  element.figure = new Figure(element, figures[name], {...words.all, ...words[name]}, announce);
  if (location.hash.startsWith(`#${element.id}:`)) begin(element.figure);
  else near.observe(element);
}
