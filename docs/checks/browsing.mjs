// A headless Chromium for the checks, and tabs that complain of what they should not say or ask for.
import {existsSync} from 'node:fs';
import {basename, delimiter, join} from 'node:path';
import {chromium} from 'playwright-core';
import {complain} from '../tools/book.mjs';

const folders = [...(process.env.PATH ?? '').split(delimiter), '/Applications/Google Chrome.app/Contents/MacOS',
                 'C:/Program Files/Google/Chrome/Application'];
// The shell comes first: without windows it takes half the processor's time of a whole browser.
const names = ['chromium-headless-shell', 'chromium', 'chromium-browser', 'google-chrome', 'Google Chrome', 'chrome.exe'];
export const executable = () => process.env.CHROMIUM ??
  names.flatMap((name) => folders.map((folder) => join(folder, name))).find(existsSync);

const flags = ['--no-sandbox', '--disable-gpu', '--enable-unsafe-swiftshader'];

/// The browser; nothing, and a complaint, where there is none.
export function openBrowser() {
  const executablePath = executable();
  if (executablePath) return chromium.launch({executablePath, args: flags});
  complain('browser', 'there is no Chromium: install chromium-headless-shell or chromium, or name one in $CHROMIUM');
  return undefined;
}

/// A tab of such a view; what goes wrong in it is told with the name that `named` gives.
export async function openTab(browser, view, named) {
  const page = await browser.newPage(view);
  page.setDefaultTimeout(180000);  // on a machine that has other work, too
  page.on('console', (message) => { if (message.type() === 'error') complain(named(), `console: ${message.text()}`); });
  page.on('pageerror', (error) => complain(named(), `error: ${error.message}`));
  page.on('request', (request) => { if (!/^(file|data|about|javascript):/.test(request.url())) complain(named(), `asks for ${request.url()}`); });
  page.on('requestfailed', (request) => { if (request.url().startsWith('file:')) complain(named(), `is not there: ${basename(request.url())}`); });
  return page;
}
