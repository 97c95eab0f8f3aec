// The figures to touch: the start of each and ten random states are compared with what the program prints for the line that
// the page shows, bit for bit; then each is moved by a pointer, by the keyboard and by a finger, sent by its link, and seen
// by axe. All of them share one module, which must stay small.
import {execFileSync} from 'node:child_process';
import {mkdirSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {binaries, build, complain, html, read, root, shownByBuild} from '../tools/book.mjs';
import {bytesSent, mostBytes} from '../tools/touch.mjs';
import {openBrowser, openTab} from './browsing.mjs';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const seed = 20261126, states = 10;
const looks = 4, alike = 0.02;  // of full brightness, on average: the edges of what is drawn twice

// Numbers from 0 to 1, the same in each run (mulberry32).
function dice(state) {
  return () => {
    state = state + 0x6D2B79F5 | 0;
    let mixed = Math.imul(state ^ state >>> 15, 1 | state);
    mixed = mixed + Math.imul(mixed ^ mixed >>> 7, 61 | mixed) ^ mixed;
    return ((mixed ^ mixed >>> 14) >>> 0) / 4294967296;
  };
}

// {contact: {point: [1, 2]}} as [["contact/point/0", 1], ["contact/point/1", 2]]
const flattened = (value, name = '') => value === null || typeof value !== 'object' ? [[name, value]] :
  Object.entries(value).flatMap(([key, part]) => flattened(part, name ? `${name}/${key}` : key));

// The results of a line, and, if some names are not among them, the numbers that the notes show.
function printedBy(line, names) {
  const [, , program, ...options] = line.replaceAll("'", '').split(' ');  // quotes are the shell's
  const folder = join(build, 'touch'), values = join(folder, 'values.json');
  const all = [...options, '--json', '--no-figures'];
  const run = (...more) => execFileSync(join(binaries, program), [...all, ...more], {cwd: root, encoding: 'utf8'});
  const results = new Map(flattened(JSON.parse(run())));
  if (names.every((name) => results.has(name))) return results;
  mkdirSync(folder, {recursive: true});
  run('--values', values);
  return new Map([...flattened(JSON.parse(read(values))), ...results]);
}

// In the page: sets a state, parts of each parameter's range, and tells what the figure then shows; without them it stays.
function setState(element, parts) {
  const {figure} = element, entries = Object.entries(figure.own.parameters);
  const between = (least, most, part) => least + part * (most - least);
  if (parts) entries.forEach(([name, {least, most}], i) => figure.change(name, Array.isArray(least)
    ? least.map((each, k) => between(each, most[k], parts[2 * i + k])) : between(least, most, parts[2 * i])));
  figure.show();
  return {answer: figure.answer, line: figure.line.textContent};
}

async function compareNumbers(figure, name) {
  const random = dice(seed), told = new Set(), seen = [];
  for (let i = 0; i <= states; ++i) {
    const {answer, line} = await figure.evaluate(setState, i ? Array.from({length: 40}, random) : null);
    if (answer.refused) complain(name, `${line}: ${answer.refused}`);
    const page = new Map(flattened(answer).filter(([key]) => !key.startsWith('drawn/')));
    for (const key of page.keys()) told.add(key);
    seen.push({line, page, program: printedBy(line, [...page.keys()])});
  }
  for (const {line, page, program} of seen)
    for (const key of told)
      if (!Object.is(page.get(key) ?? null, program.get(key) ?? null))
        complain(name, `${key} is ${page.get(key)} on the page, ${program.get(key)} by ${line}`);
  if (!told.size) complain(name, 'tells no number that the program prints');
  return told.size;
}

const stateOf = (figure) => figure.evaluate(({figure: {state}}) => JSON.stringify(state));

async function expectChange(figure, name, how, act) {
  const before = await stateOf(figure);
  await act();
  await figure.evaluate(() => new Promise((resolve) => { requestAnimationFrame(() => requestAnimationFrame(resolve)); }));
  if (before === await stateOf(figure)) complain(name, `does not move by ${how}`);
}

const middleOf = async (handle) => {
  await handle.evaluate((element) => element.scrollIntoView({block: 'center'}));
  const {x, y, width, height} = await handle.boundingBox();
  return [x + width / 2, y + height / 2];
};

// Every handle by the pointer and by the arrows; every slider by the arrows, with Shift by less; a box is ticked by the
// space bar.
async function moveByHand(page, figure, name) {
  const press = (key) => page.keyboard.press(key);
  const reset = () => figure.locator('.buttons button').last().click();
  for (const handle of await figure.locator('.handle').all()) {
    await reset();
    const label = `${name}, ${await handle.getAttribute('aria-label')}`;
    await expectChange(figure, label, 'the pointer', async () => {
      const [x, y] = await middleOf(handle);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 6, y - 9, {steps: 3});
      await page.mouse.up();
    });
    await expectChange(figure, label, 'an arrow', () => press('ArrowUp'));
    await expectChange(figure, label, 'Shift and an arrow', () => press('Shift+ArrowDown'));
    const scrolled = () => page.evaluate(() => scrollY), before = await scrolled();
    await expectChange(figure, label, 'a page', () => press('PageDown'));
    await press('Home');
    await press('End');
    if (await scrolled() !== before) complain(label, 'the page is scrolled by the keys of a slider');
    if (!await handle.getAttribute('aria-valuetext')) complain(label, 'does not say its place');
  }
  await reset();
  for (const slider of await figure.locator('input').all()) {
    const label = `${name}, ${await slider.getAttribute('aria-label')}`;
    const keys = await slider.getAttribute('type') === 'checkbox' ? ['Space'] : ['ArrowRight', 'ArrowRight', 'Shift+ArrowLeft'];
    await slider.focus();
    await expectChange(figure, label, keys[0], async () => {
      for (const key of keys) await press(key);
    });
  }
}

async function moveByFinger(page, figure, name) {
  const client = await page.context().newCDPSession(page), handle = figure.locator('.handle').first();
  if (!await handle.count()) return;
  const [x, y] = await middleOf(handle), scrolled = () => page.evaluate(() => scrollY), before = await scrolled();
  const touch = (type, ...points) =>
    client.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([a, b]) => ({x: a, y: b}))});
  await expectChange(figure, name, 'a finger', async () => {
    await touch('touchStart', [x, y]);
    await touch('touchMove', [x + 4, y + 8]);
    await touch('touchMove', [x + 8, y + 16]);
    await touch('touchEnd');
  });
  if (await scrolled() !== before) complain(name, 'the page is scrolled by a finger that moves a handle');
}

async function followLink(page, figure, name) {
  const scene = () => figure.evaluate(({figure: {state, answer}}) => JSON.stringify([state, answer]));
  const link = await figure.evaluate((element) => element.figure.link.href), before = await scene();
  await page.goto('about:blank');
  await page.goto(link);
  await figure.evaluate(begun);
  if (await scene() !== before) complain(name, `its link leads to another scene: ${link}`);
}

// In the page: waits for the first answer.
const begun = (element) => new Promise((resolve) => {
  element.scrollIntoView();
  const look = () => element.figure?.answer ? resolve() : setTimeout(look, 10);
  look();
});

// \param part  a selector of what is looked at; the contrast of a whole page is the browser's check's, and here would take long
async function seeByAxe(page, name, part) {
  const laidOut = () => [...document.querySelectorAll('.drawn')].every(
    ({scrollWidth, clientWidth, tabIndex}) => scrollWidth <= clientWidth || tabIndex === 0);
  await page.waitForFunction(laidOut, null, {timeout: 5000}).catch(() => {});  // after print it takes a moment
  await page.addScriptTag({path: axe});
  const faults = await page.evaluate(async (part) => {
    const rules = {'color-contrast': {enabled: part !== ':root'}};
    const {violations} = await globalThis.axe.run(part, {resultTypes: ['violations'], preload: false, rules});
    return violations.map(({id, nodes}) => `${id}: ${nodes[0].html.slice(0, 120)}`);
  }, part);
  for (const fault of faults) complain(name, `axe: ${fault}`);
}

async function checkWidth(page, name) {
  const {scrollWidth, clientWidth} = await page.evaluate(() => {
    const {scrollWidth, clientWidth} = document.documentElement;
    return {scrollWidth, clientWidth};
  });
  if (scrollWidth > clientWidth + 1) complain(name, `the page is ${scrollWidth - clientWidth} pixels too wide`);
}

// What is said aloud after a change is what stands below the picture.
async function checkAloud(page, figure, name) {
  const look = async () => [await page.locator('.aloud').textContent(), await figure.locator('.told').textContent()];
  let [aloud, told] = await look();
  for (let waited = 0; waited < 20 && aloud !== told; ++waited) {
    await page.waitForTimeout(250);
    [aloud, told] = await look();
  }
  if (aloud !== told) complain(name, `says "${aloud}", and shows "${told}"`);
}

// In the page, before its scripts: no WebGL; or a processor that draws by it says that it is a graphics card.
function hideGraphics() {
  const {getContext} = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind) { return kind === '2d' ? getContext.call(this, kind) : null; };
}
function feignGraphics() {
  const {getParameter} = WebGL2RenderingContext.prototype, rendererByName = 0x9246;
  WebGL2RenderingContext.prototype.getParameter = function (name) {
    return name === rendererByName ? 'a graphics card' : getParameter.call(this, name);
  };
}

// In the page: what is drawn below the marks, in few pixels, by whom, and its numbers.
function seenInSpace({figure}) {
  figure.show();
  const small = Object.assign(document.createElement('canvas'), {width: 64, height: 48}), paper = small.getContext('2d');
  paper.drawImage(figure.canvas, 0, 0, 64, 48);
  const isThree = Boolean(document.querySelector('script[src="touch-space.js"]'));
  return {isThree, answer: JSON.stringify(figure.answer), pixels: [...paper.getImageData(0, 0, 64, 48).data]};
}

// With a graphics card and without, a figure in space answers alike, and looks alike.
async function compareInSpace(browser, file, name) {
  const view = {reducedMotion: 'reduce', colorScheme: 'light', viewport: {width: 1280, height: 900}};
  const look = async (before) => {
    const random = dice(seed), seen = [];
    const tab = await openTab(browser, view, () => `${file} ${name}`);
    await tab.addInitScript(before);
    await tab.goto(pathToFileURL(join(html, file)).href);
    const figure = tab.locator(`#touch-${name}`);
    await figure.evaluate(begun);
    await tab.waitForFunction((id) => document.getElementById(id).figure.space, `touch-${name}`);
    for (let i = 0; i < looks; ++i) {
      await figure.evaluate(setState, i ? Array.from({length: 40}, random) : null);
      seen.push(await figure.evaluate(seenInSpace));
    }
    await tab.close();
    return seen;
  };
  const threes = await look(feignGraphics), flats = await look(hideGraphics);
  for (const [i, three] of threes.entries()) {
    const flat = flats[i], difference = three.pixels.reduce((sum, each, k) => sum + Math.abs(each - flat.pixels[k]), 0);
    const apart = difference / three.pixels.length / 255;
    if (!three.isThree || flat.isThree) complain(name, 'must be drawn by three with a graphics card, and flat without');
    if (three.answer !== flat.answer) complain(name, 'answers otherwise without a graphics card');
    if (apart > alike) complain(name, `with a graphics card and without its pictures are ${(100 * apart).toFixed(1)} % apart`);
  }
}

async function checkPage(browser, file, names) {
  let doing = '', numbers = 0;
  const open = async (view, visit, part) => {
    const page = await openTab(browser, {reducedMotion: 'reduce', ...view}, () => `${file} ${doing}`);
    await page.goto(pathToFileURL(join(html, file)).href);
    for (const name of names) {
      doing = name;
      const figure = page.locator(`#touch-${name}`);
      if (visit) await figure.evaluate(begun), await visit(page, figure, name);
      else if (await figure.isVisible()) complain(file, `${name} is shown without JavaScript`);
    }
    if (part) await seeByAxe(page, file, part);
    await page.close();
  };
  await open({colorScheme: 'light', viewport: {width: 1280, height: 900}}, async (page, figure, name) => {
    numbers += await compareNumbers(figure, name);
    await moveByHand(page, figure, name);
    await checkAloud(page, figure, name);
    await followLink(page, figure, name);
    if (await figure.locator('canvas').count()) await compareInSpace(browser, file, name);
  });
  const phone = {colorScheme: 'dark', viewport: {width: 390, height: 800}, hasTouch: true, isMobile: true};
  await open(phone, async (page, figure, name) => {
    await moveByFinger(page, figure, name);
    await checkWidth(page, name);
    await page.emulateMedia({media: 'print'});
    if (await figure.isVisible()) complain(name, 'is printed');
    await page.emulateMedia({media: 'screen'});
  }, ':root');
  await open({javaScriptEnabled: false});
  return numbers;
}

// Where a script is not there, the figure says so.
async function checkLack(browser, file, name) {
  const page = await browser.newPage();
  await page.route('**/touch-module.js', (route) => route.abort());
  await page.goto(pathToFileURL(join(html, file)).href);
  const figure = page.locator(`#touch-${name}`);
  await figure.evaluate((element) => element.scrollIntoView());
  await figure.getByText('touch-module.js is not there').waitFor({timeout: 5000})
    .catch(() => complain(name, 'does not say that its script is not there'));
  await page.close();
}

export async function checkTouch() {
  const pages = new Map();
  for (const {page, name} of shownByBuild().touch) pages.set(page, [...pages.get(page) ?? [], name]);
  if (!pages.size) return 'no figures to touch: clang and its C library for WebAssembly are not there';
  const bytes = bytesSent();
  if (bytes > mostBytes) complain('docs/touch', `the module is ${bytes} bytes packed, of ${mostBytes} at the most`);
  const browser = await openBrowser();
  if (!browser) return 'not run';
  const fileOf = (page) => page.replaceAll('_', '-') + '.html';
  const counts = await Promise.all([...pages].map(([page, names]) => checkPage(browser, fileOf(page), names)));
  const [[page, [name]]] = pages;
  await checkLack(browser, fileOf(page), name);
  await browser.close();
  const numbers = counts.reduce((sum, count) => sum + count, 0);
  return `${shownByBuild().touch.length} figures in ${bytes} bytes, ${numbers} numbers of each state (the start and ${states} more, seed ${seed}) equal to the program's`;
}
