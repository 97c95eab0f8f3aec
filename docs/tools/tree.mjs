// A page as a tree of its elements, by cheerio, instead of patterns over its letters.
import {load} from 'cheerio/slim';

/// The page, to be asked and changed as with jQuery. What is not changed is printed as it was written, entities too.
export const treeOf = (page) => load(page, {xml: {xmlMode: false, decodeEntities: false, recognizeSelfClosing: true}});
