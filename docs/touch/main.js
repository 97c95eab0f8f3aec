// Finds the places for figures to touch on the page, and lets each begin when it comes near.
import {make} from './page/controls.js';
import {Figure} from './core/figure.js';
import {book, script} from './core/module.js';
import {spaceOf} from './space/space.js';
import * as figures from './figures/all.js';
import './touch.css';
import {words} from './words/en.js';

const announcer = make('div', {className: 'aloud', 'aria-live': 'polite'});
const announce = (text) => { announcer.textContent = text; };

// What cannot be loaded is told where the figure would stand.
function lacks(figure, error) {
  figure.element.replaceChildren(make('figcaption', {textContent: `${figure.words.title}: ${figure.words.lacks(error.message)}`}));
  figure.element.hidden = false;
}

// The numbers first; what a picture in space needs may take longer.
async function begin(figure) {
  const begun = performance.now(), measured = (what) => performance.measure(`${figure.id}: ${what}`, {start: begun});
  const {space} = figure.own, [ask] = await Promise.all([book(), space?.mesh && script(`touch-${space.mesh}.js`)]);
  figure.begin(ask);
  measured('first answer');
  if (!space) return;
  figure.space = await spaceOf(figure, ask);
  figure.show();
  measured('first picture');
}

const start = (figure) => begin(figure).catch((error) => lacks(figure, error));

const near = new IntersectionObserver((seen) => {
  for (const {target, isIntersecting} of seen) {
    if (!isIntersecting) continue;
    near.unobserve(target);
    start(target.figure);
  }
}, {rootMargin: '800px'});

document.body.append(announcer);
for (const element of document.querySelectorAll('figure.touch')) {
  const name = element.dataset.figure;
  element.figure = new Figure(element, figures[name], {...words.all, ...words[name]}, announce);
  if (location.hash.startsWith(`#${element.id}:`)) start(element.figure);
  else near.observe(element);
}
