// Every link, anchor and image within the site resolves; nothing is fetched from elsewhere.
import {existsSync} from 'node:fs';
import {basename, dirname, resolve} from 'node:path';
import {complain, filesBelow, html, read} from '../tools/book.mjs';
import {idsOf, targetsOf, unresolvedIn} from '../tools/references.mjs';
import {treeOf} from '../tools/tree.mjs';

const isOurs = (file) => file.endsWith('.html') && !file.includes('/search/');
const linking = 'a, link, img, script, iframe, source, image, use, object, video';

// What is asked of a page, once it has been read: the tree itself is large.
function seen(file) {
  const page = read(file), tree = treeOf(page), ids = idsOf(tree), targets = targetsOf(tree);
  const links = tree(linking).toArray().flatMap(({name, attribs}) =>
    ['href', 'xlink:href', 'src', 'data'].filter((each) => each in attribs).map((each) => [name, each, attribs[each]]));
  return {targets, links, unresolved: unresolvedIn(tree, targets),
          twice: new Set(ids.filter((id, i) => ids.indexOf(id) !== i)), hasToken: /[\uE000-\uF8FF]/.test(page)};
}

function checkLink(file, [element, attribute, target], pages) {
  const name = basename(file);
  if (/^(javascript:|data:)/.test(target)) return;
  if (/^[a-z]+:/.test(target)) {
    if (element !== 'a') complain(name, `${element} ${attribute} is fetched from elsewhere: ${target}`);
    return;
  }
  const [path, anchor] = target.split('#');
  if (!path) return;  // within the page: below
  const to = resolve(dirname(file), decodeURIComponent(path));
  if (!existsSync(to)) complain(name, `leads nowhere: ${target}`);
  else if (anchor && pages.has(to) && !pages.get(to).targets.has(decodeURIComponent(anchor))) complain(name, `no such anchor: ${target}`);
}

/// Checks the site in that folder.
export function checkLinksIn(folder) {
  const pages = new Map(filesBelow(folder, isOurs).map((file) => [file, seen(file)]));
  let links = 0;
  for (const [file, page] of pages) {
    const name = basename(file);
    for (const link of page.links) checkLink(file, link, pages);
    for (const target of page.unresolved) complain(name, `no such anchor or drawing: #${target}`);
    if (page.twice.size) complain(name, `ids stand twice: ${[...page.twice].slice(0, 5).join(', ')}`);
    if (page.hasToken) complain(name, 'a token was left in the page');
    links += page.links.length;
  }
  for (const file of filesBelow(folder, (name) => name.endsWith('.svg')))
    for (const target of unresolvedIn(treeOf(read(file)))) complain(basename(file), `no such drawing: #${target}`);
  return `${links} links on ${pages.size} pages`;
}

export const checkLinks = () => checkLinksIn(html);
