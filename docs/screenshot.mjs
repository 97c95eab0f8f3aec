// The picture of a page that README.md shows: the sphere that meets a plane, in light and in dark, side by side.
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';
import {executable} from './checks/browsing.mjs';
import {docs, html} from './tools/book.mjs';

const [page, width, height] = ['plane.html', 1180, 1000];
const picture = join(docs, 'screenshot.png');
const browser = await chromium.launch({executablePath: executable(), args: ['--no-sandbox', '--disable-gpu']});

async function seen(colorScheme) {
  const tab = await browser.newPage({colorScheme, viewport: {width, height}});
  await tab.goto(pathToFileURL(join(html, page)).href);
  await tab.waitForTimeout(500);  // for the fonts
  const image = await tab.screenshot();
  await tab.close();
  return `data:image/png;base64,${image.toString('base64')}`;
}

const [light, dark] = [await seen('light'), await seen('dark')];
const both = await browser.newPage({viewport: {width, height}});
await both.setContent(`<body style="margin:0"><img src="${light}"><img src="${dark}" style="position:absolute;left:0;top:0;` +
                      `clip-path:polygon(62% 0,100% 0,100% 100%,44% 100%)"></body>`);
await both.screenshot({path: picture});
await browser.close();
console.log('The picture is docs/screenshot.png.');
