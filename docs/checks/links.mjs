// Every link, anchor and image within the site resolves; nothing is fetched from elsewhere.
import {existsSync} from 'node:fs';
import {basename, dirname, join, resolve} from 'node:path';
import {complain, filesBelow, html, read} from '../tools/book.mjs';
import {idsOf, unresolvedIn} from '../tools/references.mjs';

const isOurs = (file) => file.endsWith('.html') && !file.includes('/search/');

export function checkLinks() {
  const pages = filesBelow(html, isOurs);
  const anchors = new Map(pages.map((file) => [file, idsOf(read(file))]));
  let links = 0;
  for (const file of pages) {
    const page = read(file), name = basename(file);
    for (const [, element, attributes] of page.matchAll(/<(a|link|img|script|iframe|source|image|use|object|video)\b([^>]*)>/g))
      for (const [, attribute, target] of attributes.matchAll(/\s(?:xlink:)?(href|src|data)="([^"]*)"/g)) {
        ++links;
        if (/^(javascript:|data:)/.test(target)) continue;
        if (/^[a-z]+:/.test(target)) {
          if (element !== 'a') complain(name, `${element} ${attribute} is fetched from elsewhere: ${target}`);
          continue;
        }
        const [path, anchor] = target.split('#');
        if (!path) continue;  // within the page: below
        const to = resolve(dirname(file), decodeURIComponent(path));
        if (!existsSync(to)) complain(name, `leads nowhere: ${target}`);
        else if (anchor && anchors.has(to) && !anchors.get(to).has(decodeURIComponent(anchor))) complain(name, `no such anchor: ${target}`);
      }
    for (const target of unresolvedIn(page, anchors.get(file))) complain(name, `no such anchor or drawing: #${target}`);
    const twice = [...page.matchAll(/\sid=(["'])([^"']+)\1/g)].map(([, , id]) => id).filter((id, i, all) => all.indexOf(id) !== i);
    if (twice.length) complain(name, `ids stand twice: ${[...new Set(twice)].slice(0, 5).join(', ')}`);
    if (/[\uE000-\uF8FF]/.test(page)) complain(name, 'a token was left in the page');
  }
  return `${links} links on ${pages.length} pages`;
}
