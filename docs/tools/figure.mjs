// A committed figure becomes a part of its page: it then follows the page's theme and needs no file of its own.
import {existsSync} from 'node:fs';
import {optimize} from 'svgo';
import {figureFile, read} from './book.mjs';
import {unresolvedIn} from './references.mjs';
import {treeOf} from './tree.mjs';

const darkRules = new Set();  // of all figures that were inlined

const isDarkStyle = ({name, children}) => name === 'style' && children[0].value.includes('(prefers-color-scheme:dark)');

// [fill="#0072b2"]{fill:#58ace6}: what the figure itself says for a dark page.
const darkRulesOf = ({children}) => children[0].value.match(/\[[a-z]+="[^"]*"\]\{[^}]*\}/g) ?? [];

const isPaper = ({name, attributes}, parent) => name === 'rect' && parent.name === 'g' && attributes.fill === '#ffffff' &&
    attributes.x === '0' && attributes.y === '0';

const smallestLabel = 11;  // pixels

// How large the letters of each text are, where they are largest: a subscript may be smaller.
function sizesOf(node, inherited) {
  const size = parseFloat(node.attributes?.['font-size'] ?? inherited);
  const below = (node.children ?? []).flatMap((child) => sizesOf(child, size));
  if (node.name === 'text') return below.length ? [Math.max(...below)] : [];
  return node.type === 'text' && node.value.trim() ? [size] : below;
}

// How wide a drawing has to be for its labels to be read on any screen.
function leastWidth(svg) {
  const [, , width] = svg.attributes.viewBox.split(' ').map(Number);
  const labels = (svg.children ?? []).flatMap((child) => sizesOf(child, NaN));
  return labels.length ? Math.ceil(smallestLabel / Math.min(...labels.filter((size) => size > 0)) * width) : 0;
}

// The page is the paper, and has the colours; the picture is told in words, and is as wide as its column lets it be.
const intoPage = (alternative) => ({name: 'intoPage', fn: () => ({element: {enter(node, parent) {
  if (isDarkStyle(node)) darkRulesOf(node).forEach((rule) => darkRules.add(rule));
  if (isDarkStyle(node) || isPaper(node, parent)) parent.children = parent.children.filter((child) => child !== node);
  if (node.name !== 'svg') return;
  const {viewBox, width, xmlns} = node.attributes, xlink = node.attributes['xmlns:xlink'];
  node.attributes = {viewBox, style: `--width:${parseFloat(width)}px;--least:${leastWidth(node)}px`, xmlns, 'xmlns:xlink': xlink, role: 'img', 'aria-label': alternative};
}}})});

// What is drawn is left as it is, to the last digit. gnuplot gives some of its ids twice; those that a mark is known by
// are made unlike those of all other figures, and marks that draw nothing go.
const optimized = (svg, ...plugins) => optimize(svg, {plugins}).data;
const cleaned = (svg, alternative) => optimized(svg, 'removeDoctype', 'removeXMLProcInst', 'removeTitle',
  {name: 'removeDesc', params: {removeAny: true}}, intoPage(alternative));
const withoutUnused = (svg) => optimized(svg, {name: 'cleanupIds', params: {minify: false, force: true}},
  'removeUselessDefs', 'removeEmptyContainers');
const withOwnNames = (svg, prefix) => optimized(svg, {name: 'prefixIds', params: {prefix, delim: '-', prefixClassNames: false}});

/// How many points a figure plots: gnuplot draws each by a reference to its mark, which stands among the definitions.
export const plottedIn = (svg) => svg.replace(/<defs>[^]*?<\/defs>/g, '').match(/<use\b/g)?.length ?? 0;

// None may be lost on the way, and none lead nowhere.
function checkMarks(path, before, after) {
  const [lost] = unresolvedIn(treeOf(after));
  if (lost) throw new Error(`the figure ${path} draws a mark that it does not have: ${lost}`);
  if (plottedIn(before) !== plottedIn(after))
    throw new Error(`the figure ${path} has ${plottedIn(before)} plotted points, its page ${plottedIn(after)}`);
}

/// The figure of that path (from the root) as inline SVG with its alternative text.
export function inlineFigure(path, prefix, alternative) {
  const file = figureFile(path);
  if (!existsSync(file)) throw new Error(`there is no figure ${path}`);
  const source = read(file);
  let svg = cleaned(source, alternative);
  for (let before = ''; before !== svg;) [before, svg] = [svg, withoutUnused(svg)];  // a mark may be drawn by another alone
  const result = withOwnNames(svg, prefix);
  checkMarks(path, source, result);
  return result;
}

const papers = {light: '#fffefb', dark: '#15191c'};  // as in theme/book.css
const parts = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
const hex = (rgb) => '#' + rgb.map((part) => Math.round(part).toString(16).padStart(2, '0')).join('');
const luminance = (colour) => parts(colour).map((part) => part / 255)
    .map((part) => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4)
    .reduce((sum, part, i) => sum + part * [0.2126, 0.7152, 0.0722][i], 0);

/// The colour, moved towards ink as far as letters need it to be read on the paper (WCAG AA: 4.5 to 1).
export function forLetters(colour, theme) {
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
