// Formulas are set once, here, as SVG with MathML for screen readers: the pages need no script for them.
import {createRequire} from 'node:module';

const require = createRequire(import.meta.url);
const MathJax = await require('mathjax').init({
  loader: {load: ['input/tex', 'output/svg', 'a11y/assistive-mml']},
  tex: {
    packages: {'[-]': ['noundefined', 'noerrors']},
    macros: {vec: ['\\mathbf{#1}', 1], norm: ['\\lVert #1 \\rVert', 1], abs: ['\\lvert #1 \\rvert', 1],
             sgn: '\\operatorname{sgn}'},
    formatError: (_, error) => { throw error; },
  },
  svg: {fontCache: 'none'},
  startup: {typeset: false},
});
const adaptor = MathJax.startup.adaptor;

/// The formula as HTML. \throws an Error with MathJax's words if it is not well formed.
export function formula(tex, display = false) {
  const node = MathJax.tex2svg(tex, {display});
  const markup = adaptor.outerHTML(node);
  if (markup.includes('merror')) throw new Error(`formula ${tex}: not understood`);
  return markup.replaceAll(' data-mml-node="', ' data-m="').replace(/ data-m="[^"]*"/g, '');
}

/// The style sheet that goes with formulas.
export const formulaStyle = () => adaptor.textContent(MathJax.svgStylesheet());

/// Each glyph once a page: outlines move into one list that every formula refers to.
export function shareGlyphs(tree) {
  const ids = new Map();  // of outlines
  tree('path[data-c]').each((_, glyph) => {
    const {d: outline, ...rest} = glyph.attribs;
    delete rest['data-c'];
    if (!outline) return tree(glyph).remove();
    if (!ids.has(outline)) ids.set(outline, `g${ids.size}`);
    Object.assign(glyph, {name: 'use', attribs: {href: '#' + ids.get(outline), ...rest}});
  });
  const list = [...ids].map(([outline, id]) => `<path id="${id}" d="${outline}"/>`).join('');
  tree('#glyphs').replaceWith(list && `<svg class="glyphs" width="0" height="0" aria-hidden="true"><defs>${list}</defs></svg>`);
}
