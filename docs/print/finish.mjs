// What Chromium does not write into a PDF: who wrote it, what it is about, how it is to be shown and printed.
import {readFileSync, writeFileSync} from 'node:fs';
import {PDFDocument, PDFName, Duplex} from 'pdf-lib';
import {author, subtitle, title, version} from './front.mjs';

export async function finishPdf(file) {
  const pdf = await PDFDocument.load(readFileSync(file), {updateMetadata: false});
  pdf.setTitle(title, {showInWindowTitleBar: true});
  pdf.setAuthor(author);
  pdf.setSubject(`${subtitle}. After the paper by Shing-Min Hu. Version ${version}. Text CC BY 4.0, code MIT.`);
  pdf.setKeywords(['collision detection', 'continuous collision detection', 'sweep', 'tween', 'animation', 'C++']);
  pdf.setCreator(`${title} ${version}, ./course notes --pdf`);
  pdf.setLanguage('en');
  pdf.catalog.getOrCreateViewerPreferences().setDuplex(Duplex.DuplexFlipLongEdge);
  pdf.catalog.set(PDFName.of('PageLayout'), PDFName.of('TwoPageRight'));
  pdf.catalog.set(PDFName.of('PageMode'), PDFName.of('UseOutlines'));
  writeFileSync(file, await pdf.save());
}
