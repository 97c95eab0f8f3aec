// Every page in a headless Chromium, the book's light and dark, wide and narrow: no request leaves the machine, no error on
// the console, no formula in error, nothing wider than its page, text and figures' letters large and with contrast enough
// (WCAG AA); and by the keyboard alone.
import {basename} from 'node:path';
import {pathToFileURL} from 'node:url';
import {chapters, complain, filesBelow, html, otherPages} from '../tools/book.mjs';
import {openBrowser, openTab} from './browsing.mjs';

const wide = {width: 1280, height: 900}, phone = {width: 390, height: 800};
const keyboard = new Set(['index.html', 'plane.html', 'tween-bounce.html', 'library-motion.html']);  // one of each kind
const isOurs = (file) => file.endsWith('.html') && !file.includes('/search/');

// These run in the page, each by itself.
function faultsOfParts(wholeBook) {
  const faults = [];
  const wide = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  if (wholeBook && wide > 1) faults.push(`the page is ${wide} pixels too wide`);
  for (const part of document.querySelectorAll('div.fragment, pre.output, pre.shell'))
    if (part.offsetParent && part.scrollWidth > part.clientWidth + 1) faults.push(`code must be scrolled: ${part.textContent.trim().slice(0, 40)}`);
  if (document.querySelector('[data-mml-node="merror"], mjx-merror, merror')) faults.push('a formula is in error');
  for (const image of document.querySelectorAll('.drawn > svg'))
    if (image.getAttribute('role') !== 'img' || !image.getAttribute('aria-label'))
      faults.push('a figure without alternative text');
  if (document.querySelectorAll('main').length !== 1 || !document.querySelector('nav')) faults.push('a landmark is missing');
  if (document.querySelectorAll('h1').length !== 1) faults.push(`${document.querySelectorAll('h1').length} titles`);
  return faults;
}

// A subscript may be smaller than the letter that it belongs to.
function faultsOfLetters() {
  const least = 10.9, faults = [];
  for (const text of document.querySelectorAll('.drawn > svg text')) {
    const matrix = text.getScreenCTM(), sizes = [text, ...text.querySelectorAll('tspan')]
        .filter(({childNodes}) => [...childNodes].some((node) => node.nodeType === 3 && node.data.trim()))
        .map((part) => parseFloat(getComputedStyle(part).fontSize));
    const size = matrix && sizes.length ? Math.max(...sizes) * Math.hypot(matrix.a, matrix.b) : least;
    if (size < least) faults.push(`letters of ${size.toFixed(1)} pixels: "${text.textContent.trim()}"`);
  }
  return faults;
}

function faultsOfContrast() {
  const faults = [], seen = new Set();
  const canvas = document.createElement('canvas').getContext('2d', {willReadFrequently: true});
  const rgba = (colour) => {
    canvas.clearRect(0, 0, 1, 1);
    canvas.fillStyle = colour;
    canvas.fillRect(0, 0, 1, 1);
    return [...canvas.getImageData(0, 0, 1, 1).data];
  };
  const linear = (part) => part <= 0.03928 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  const luminance = ([r, g, b]) => 0.2126 * linear(r / 255) + 0.7152 * linear(g / 255) + 0.0722 * linear(b / 255);
  const behind = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const colour = rgba(getComputedStyle(at).backgroundColor);
      if (colour[3] > 250) return colour;
    }
    return [255, 255, 255, 255];
  };
  const check = (colour, element, least, what) => {
    const key = colour + getComputedStyle(element.parentElement).backgroundColor + what;
    if (seen.has(key)) return;
    seen.add(key);
    const [a, b] = [luminance(rgba(colour)), luminance(behind(element))].sort((x, y) => y - x);
    const contrast = (a + 0.05) / (b + 0.05);
    if (contrast < least) faults.push(`contrast ${contrast.toFixed(1)}: ${what} "${element.textContent.trim().slice(0, 24)}"`);
  };
  const hasWords = ({childNodes}) => [...childNodes].some((node) => node.nodeType === 3 && node.data.trim());
  for (const element of document.querySelectorAll('main *, nav#contents *, header.site *')) {
    if (!element.offsetParent || element.closest('svg, mjx-assistive-mml, .skip') || !hasWords(element)) continue;
    const style = getComputedStyle(element), least = parseFloat(style.fontSize) >= 24 ? 3 : 4.5;
    check(style.color, element, least, `${element.localName}.${element.className}`);
  }
  for (const text of document.querySelectorAll('.drawn > svg text')) {  // against the paper
    const {fill} = getComputedStyle(text);
    if (fill !== 'none') check(fill, text.closest('figure'), 4.5, `the figures' letters in ${fill}`);
  }
  return faults;
}

function faultsOfNames(wholeBook) {
  const faults = [];
  const name = (element) => element.getAttribute('aria-label') || element.title || element.textContent.trim();
  for (const element of document.querySelectorAll('button, summary, main a[href], nav a[href]'))
    if (!name(element) && !element.querySelector('[aria-label], [title], img[alt]')) faults.push(`${element.localName} without a name: ${element.outerHTML.slice(0, 60)}`);
  let level = 1;
  for (const heading of document.querySelectorAll('main h1, main h2, main h3, main h4')) {
    const next = +heading.localName[1];
    if (wholeBook && next > level + 1) faults.push(`the heading "${heading.textContent.trim().slice(0, 30)}" leaves out a level`);
    level = next;
  }
  return faults;
}

// As one who has no mouse goes through the page: the first stop is the way past the contents, every stop can be seen, and
// everything that can be pressed is a stop.
async function faultsOfKeyboard(page) {
  await page.evaluate(() => document.fonts.ready);  // a letter that comes late moves what has the focus
  const faults = [], wanted = await page.evaluate(() => {
    document.activeElement?.blur();
    scrollTo(0, 0);
    const shown = (element) => element.checkVisibility({visibilityProperty: true}) && !element.disabled && element.tabIndex >= 0;
    const all = [...document.querySelectorAll('a[href], button, summary, input, .drawn[tabindex]')]
        .filter((element) => shown(element) && !element.closest('#MSearchResultsWindow, #MSearchSelectWindow'));
    all.forEach((element, i) => { element.dataset.stop = i; });
    return all.length;
  });
  const reached = new Set();
  for (let i = 0; i < 2 * wanted && reached.size < wanted; ++i) {  // what scrolls may be a stop as well
    await page.keyboard.press('Tab');
    const look = () => page.evaluate(() => {
      const at = document.activeElement, style = getComputedStyle(at), inner = at.querySelector?.('rect');
      const box = at.getBoundingClientRect();
      return {id: at.dataset.stop, text: at.textContent.trim().slice(0, 30), skip: at.classList.contains('skip'),
              inside: box.right > 0 && box.bottom > 0, where: `${box.left}, ${box.top}`,
              seen: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 1 ||
                    !!inner && getComputedStyle(inner).strokeWidth === '1.8px' || at.id === 'MSearchField'};
    });
    let stop = await look();
    for (let waited = 0; waited < 10 && !(stop.seen && stop.inside); ++waited) {  // the page may still be laid out
      await page.waitForTimeout(50);
      stop = await look();
    }
    if (i === 0 && !stop.skip) faults.push('the first stop of the Tab key is not the way to the text');
    if (stop.id === undefined) continue;
    if (!reached.has(stop.id) && !(stop.seen && stop.inside)) faults.push(`"${stop.text}" has the focus, and ${stop.seen ? `is at ${stop.where}, off the screen` : 'has no outline'}`);
    reached.add(stop.id);
  }
  if (reached.size < wanted) faults.push(`${wanted - reached.size} of ${wanted} links and buttons are out of the Tab key's reach`);
  return faults;
}

// A tab that visits page after page; what it hears is about the page that is open. A page's colours are changed while it is
// open, as its reader's machine does at sunset.
// Motion is reduced: where the focus is after a key does not depend on how far a smooth scroll has come.
async function openVisitor(browser, viewport) {
  let name = '';
  const page = await openTab(browser, {colorScheme: 'light', reducedMotion: 'reduce', viewport}, () => name);
  const look = async (title, wholeBook) => {
    name = title;
    for (const faults of [faultsOfParts, faultsOfLetters, faultsOfContrast, faultsOfNames])
      for (const fault of await page.evaluate(faults, wholeBook)) complain(name, fault);
  };
  return async (file, wholeBook) => {
    const title = basename(file);
    name = title;
    await page.emulateMedia({colorScheme: 'light'});
    await page.goto(pathToFileURL(file).href);
    await look(`${title} (light, ${viewport.width})`, wholeBook);
    if (!wholeBook || viewport !== wide) return;
    if (keyboard.has(title)) for (const fault of await faultsOfKeyboard(page)) complain(`${name}, keyboard`, fault);
    await page.emulateMedia({colorScheme: 'dark'});
    await look(`${title} (dark, ${viewport.width})`, wholeBook);
  };
}

// Doxygen's lists of names are all alike: of each kind one in so many is looked at, unless all are wanted.
const lists = /(-members|^functions.*|^dir_.*|^globals.*)\.html$/, oneIn = 8;

function pagesToVisit(everyOne) {
  const pages = filesBelow(html, isOurs), isList = (file) => lists.test(basename(file));
  return [...pages.filter((file) => !isList(file)), ...pages.filter(isList).filter((_, i) => everyOne || i % oneIn === 0)];
}

export async function checkBrowser({everyOne = false} = {}) {
  const browser = await openBrowser();
  if (!browser) return 'not run';
  const book = new Set([...chapters, ...otherPages].map(({page}) => page)), isBook = (file) => book.has(basename(file));
  const pages = pagesToVisit(everyOne);
  // Loading a page is half waiting: two tabs for either width take the next one from a common list.
  const lefts = [[wide, pages.slice()], [phone, pages.filter(isBook)]];
  await Promise.all(lefts.flatMap((left) => [left, left]).map(async ([viewport, left]) => {
    const visit = await openVisitor(browser, viewport);
    for (let file; (file = left.shift());) await visit(file, isBook(file));
  }));
  await browser.close();
  return `${pages.length} pages`;
}
