// Finds numbers that were typed by hand where a run could say them: those with a decimal point, and whole ones of
// three digits or more, in words and in formulas. Sections (§1.2), years and equation numbers are none.

const notCounted = [
  /\{\{[^{}]*\}\}/g,
  /\\tag\{[^}]*\}/g,
  /§\s?\d(?:\.\d)*(?:[–,] ?\d(?:\.\d)*)*/g,
  /[\w./-]+#\d+/g,
  /\b(?:1[5-9]|20)\d\d\b/g,
];

// The words of a text again; what is no words leaves a gap.
const spoken = {text: ({content}) => content, formula: ({content}) => content, section: ({content}) => `§${content}`,
                softbreak: () => '\n'};
const wordsOf = (parts) => parts.map((part) => spoken[part.type]?.(part) ?? ' ').join('');

// [line, words] for each part of a page that has any.
function* textsOf(parts) {
  for (const {type, meta, children} of parts) {
    if (type === 'equation') yield [meta.line, meta.tex];
    if (type === 'figure_open') yield [meta.line, meta.alternative];
    if (children) yield [children[0]?.meta.line, wordsOf(children)];
  }
}

/// Calls `found(line, number)` for each in a page that markdown.mjs has read.
export function typedNumbers(parts, found) {
  for (const [line, words] of textsOf(parts)) {
    const prose = notCounted.reduce((text, pattern) => text.replace(pattern, ' '), words);
    for (const {0: number, index} of prose.matchAll(/(?<![\w.])\d+(?:,\d{3})*(?:\.\d+)?(?![\w]|\.\d)/g)) {
      const digits = number.replaceAll(',', '');
      if (digits.includes('.') || digits.length >= 3) found(line + prose.slice(0, index).split('\n').length - 1, number);
    }
  }
}
