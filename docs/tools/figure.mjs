// A committed figure becomes a part of its page: it then follows the page's theme and needs no file of its own.
import {existsSync} from 'node:fs';
import {join} from 'node:path';
import {escape, read, root} from './book.mjs';

const darkRules = new Set();  // of all figures that were inlined

// [fill="#0072b2"]{fill:#58ace6}: what the figure itself says for a dark page.
function takeDarkRules(svg) {
  const style = /<style>([\s\S]*?)<\/style>/.exec(svg)?.[1] ?? '';
  const dark = /@media \(prefers-color-scheme:dark\)\{([\s\S]*)\}\s*$/.exec(style)?.[1] ?? '';
  for (const [rule] of dark.matchAll(/\[[a-z]+="[^"]*"\]\{[^}]*\}/g)) darkRules.add(rule);
}

function withoutUnused(svg) {
  const used = (id) => svg.includes(`#${id}'`) || svg.includes(`#${id}"`) || svg.includes(`#${id})`);
  for (let before = ''; before !== svg;) {
    before = svg;
    svg = svg.replace(/[ \t]*<(path|circle|rect|use|filter)\b[^>]*\bid=['"]([^'"]+)['"][^>]*?(?:\/>|>[\s\S]*?<\/\1>)\s*/g,
                      (whole, tag, id) => used(id) ? whole : '');
  }
  return svg;
}

function withOwnNames(svg, prefix) {
  return svg.replace(/\bid=(['"])([^'"]+)\1/g, `id=$1${prefix}-$2$1`)
      .replace(/\b((?:xlink:)?href|begin|end)=(['"])#?([A-Za-z][\w-]*)(?=[.'"])/g,
               (whole, name, quote, id) => name === 'begin' || name === 'end' ? whole : `${name}=${quote}#${prefix}-${id}`)
      .replace(/url\(#([^)]+)\)/g, `url(#${prefix}-$1)`);
}

/// The figure of that path (from the root) as inline SVG with its alternative text.
export function inlineFigure(path, prefix, alternative) {
  const file = join(root, path);
  if (!existsSync(file)) throw new Error(`there is no figure ${path}`);
  let svg = read(file);
  takeDarkRules(svg);
  const width = /<svg[^>]*?\bwidth="([\d.]+)/.exec(svg)?.[1] ?? '720';
  svg = svg.replace(/^[\s\S]*?(?=<svg)/, '')
      .replace(/<style>[\s\S]*?<\/style>\s*/, '')
      .replace(/<title>[\s\S]*?<\/title>\s*/g, '').replace(/<desc>[\s\S]*?<\/desc>\s*/g, '')
      .replace(/<rect x="0" y="0" width="[\d.]+" height="[\d.]+" fill="#ffffff"\/>\s*/i, '')  // the paper is the page
      .replace(/ id="gnuplot_[^"]*"/g, '')  // nothing refers to them, and gnuplot gives some twice
      .replace(/<g [^>]*>\s*<\/g>\s*/g, '')
      .replace(/\n\s*/g, '\n');
  svg = withOwnNames(withoutUnused(svg), prefix);
  return svg.replace(/<svg[^>]*?>/, (open) => {
    const box = /viewBox="[^"]*"/.exec(open)[0];
    return `<svg ${box} style="--width:${width}px" xmlns="http://www.w3.org/2000/svg" ` +
           `xmlns:xlink="http://www.w3.org/1999/xlink" role="img" aria-label="${escape(alternative)}">`;
  });
}

const papers = {light: '#fffefb', dark: '#15191c'};  // as in theme/book.css
const parts = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
const hex = (rgb) => '#' + rgb.map((part) => Math.round(part).toString(16).padStart(2, '0')).join('');
const luminance = (colour) => parts(colour).map((part) => part / 255)
    .map((part) => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4)
    .reduce((sum, part, i) => sum + part * [0.2126, 0.7152, 0.0722][i], 0);

// The colour, moved towards ink as far as letters need it to be read on the paper (WCAG AA: 4.5 to 1).
function forLetters(colour, theme) {
  const end = theme === 'light' ? 0 : 255;
  for (let part = 0;; part += 0.02) {
    const moved = hex(parts(colour).map((value) => value + part * (end - value)));
    const [low, high] = [luminance(moved), luminance(papers[theme])].sort((a, b) => a - b);
    if ((high + 0.05) / (low + 0.05) >= 4.6) return moved;
  }
}

/// The colours of figures, each for a light page and a dark one; those of letters apart.
export function figureStyle() {
  const rules = [...darkRules].sort().map((rule) => {
    const [, name, light, dark] = /^\[([a-z]+)="([^"]*)"\]\{[a-z]+:([^}]*)\}/.exec(rule);
    const paper = light === '#ffffff' ? 'var(--paper)' : `light-dark(${light}, ${dark})`;
    const letters = name === 'fill' && light !== '#ffffff'
      ? `\nfigure svg [fill="${light}"] > text { fill: light-dark(${forLetters(light, 'light')}, ${forLetters(dark, 'dark')}); }` : '';
    return `figure svg [${name}="${light}"] { ${name}: ${paper}; }${letters}`;
  });
  return rules.join('\n') + '\n';
}
