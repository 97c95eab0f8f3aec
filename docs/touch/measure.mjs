// What the figures to touch cost, measured on the built book: node docs/touch/measure.mjs
// The module's size as it is loaded, the time to each figure's first answer, in space also to its first picture, and the
// pictures a second while it is dragged: by its first handle, or by its first slider.
import {statSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {gzipSync} from 'node:zlib';
import {openBrowser, openTab} from '../checks/browsing.mjs';
import {html, read, root, shownByBuild, stopIfWrong} from '../tools/book.mjs';
import {bytesSent} from '../tools/touch.mjs';

const seconds = 3;

// In the page: counts the pictures that are drawn until it is asked.
function countPictures() {
  const count = {begun: performance.now(), pictures: 0};
  const step = () => { ++count.pictures; requestAnimationFrame(step); };
  requestAnimationFrame(step);
  globalThis.picturesASecond = () => count.pictures / (performance.now() - count.begun) * 1000;
}

async function drag(page, handle) {
  await handle.evaluate((element) => element.scrollIntoView({block: 'center'}));
  const {x, y, width, height} = await handle.boundingBox(), [a, b] = [x + width / 2, y + height / 2];
  await page.mouse.move(a, b);
  await page.mouse.down();
  await page.evaluate(countPictures);
  for (const end = Date.now() + 1000 * seconds; Date.now() < end;)
    await page.mouse.move(a + 30 * Math.sin(Date.now() / 200), b - 30 + 30 * Math.cos(Date.now() / 200));
  await page.mouse.up();
  return page.evaluate(() => globalThis.picturesASecond());
}

const wasm = statSync(join(root, 'build/touch/book.wasm')).size, scripts = gzipSync(read(html, 'touch.js')).length;
console.log(`the module: ${wasm} bytes, ${bytesSent()} gzipped as it is loaded; scripts ${scripts} gzipped`);
const browser = await openBrowser();
stopIfWrong('opening a browser');
for (const {name, page: id} of shownByBuild().touch) {
  const page = await openTab(browser, {viewport: {width: 1280, height: 900}, reducedMotion: 'reduce'}, () => name);
  await page.goto(pathToFileURL(join(html, id.replaceAll('_', '-') + '.html')).href);
  const figure = page.locator(`#touch-${name}`);
  await figure.evaluate((element) => element.scrollIntoView());
  await page.waitForFunction((id) => document.getElementById(id).figure.answer, `touch-${name}`);
  if (await figure.locator('canvas').count())
    await page.waitForFunction((id) => document.getElementById(id).figure.space, `touch-${name}`);
  const first = await page.evaluate((id) => ['answer', 'picture'].flatMap((what) =>
    performance.getEntriesByName(`${id}: first ${what}`).map(({duration}) => `first ${what} after ${duration.toFixed(0)} ms`)), `touch-${name}`);
  const pictures = await drag(page, figure.locator('.handle, input[type=range]').first());
  console.log(`${name}: ${first.join(', ')}, ${pictures.toFixed(1)} pictures a second while dragged`);
  await page.close();
}
await browser.close();
stopIfWrong('measuring the figures to touch');
