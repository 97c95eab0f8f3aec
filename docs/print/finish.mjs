// What Chromium does not write into a PDF: who wrote it, what it is about, how it is to be shown and printed.
import {readFileSync, writeFileSync} from 'node:fs';
import {PDFDocument, PDFHexString, PDFName, Duplex} from 'pdf-lib';
import {language} from '../tools/book.mjs';
import {say} from '../tools/words.mjs';
import {author, command, subtitle, title, version} from './front.mjs';

/// Each bookmark of a document, those below it after it.
export function* bookmarksOf(document) {
  function* from(item) {
    for (let at = item; at; at = at.lookup(PDFName.of('Next'))) {
      yield at;
      yield* from(at.lookup(PDFName.of('First')));
    }
  }
  yield* from(document.catalog.lookup(PDFName.of('Outlines'))?.lookup(PDFName.of('First')));
}

export const titleOf = (bookmark) => bookmark.lookup(PDFName.of('Title')).decodeText();

// A heading that a page break moves is named twice by Chromium, in one bookmark.
function nameOnce(bookmark) {
  const title = titleOf(bookmark), half = title.slice(0, title.length / 2);
  if (half && half + half === title) bookmark.set(PDFName.of('Title'), PDFHexString.fromText(half));
}

export async function finishPdf(file) {
  const pdf = await PDFDocument.load(readFileSync(file), {updateMetadata: false});
  for (const bookmark of bookmarksOf(pdf)) nameOnce(bookmark);
  pdf.setTitle(title, {showInWindowTitleBar: true});
  pdf.setAuthor(author);
  pdf.setSubject(say('subject', subtitle, version));
  pdf.setKeywords(['collision detection', 'continuous collision detection', 'sweep', 'tween', 'animation', 'C++']);
  pdf.setCreator(`${title} ${version}, ${command}`);
  pdf.setLanguage(language);
  pdf.catalog.getOrCreateViewerPreferences().setDuplex(Duplex.DuplexFlipLongEdge);
  pdf.catalog.set(PDFName.of('PageLayout'), PDFName.of('TwoPageRight'));
  pdf.catalog.set(PDFName.of('PageMode'), PDFName.of('UseOutlines'));
  writeFileSync(file, await pdf.save());
}
