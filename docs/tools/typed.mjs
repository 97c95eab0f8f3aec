// Finds numbers that were typed by hand where a run could say them: those with a decimal point, and whole ones of
// three digits or more. Sections (§1.2), years, addresses, code and equation numbers are none.

const blank = (part) => ' '.repeat(part.length);

const notProse = [
  /^```[\s\S]*?^```$/gm,
  /<!--[\s\S]*?-->/g,
  /^\\(?:snippet|folded|files|output) .*$/gm,
  /`[^`\n]*`/g,
  /\{\{[^{}]*\}\}/g,
  /\]\([^)]*\)/g,
  /\{#[^}]*\}/g,
  /\\tag\{[^}]*\}/g,
  /§\s?\d(?:\.\d)*(?:[–,] ?\d(?:\.\d)*)*/g,
  /\[@[^\]]*\]/g,
  /[\w./-]+#\d+/g,
  /\b(?:1[5-9]|20)\d\d\b/g,
];

/// Calls `found(index, number)` for each.
export function typedNumbers(text, found) {
  for (const pattern of notProse) text = text.replace(pattern, blank);
  for (const match of text.matchAll(/(?<![\w.])\d+(?:,\d{3})*(?:\.\d+)?(?![\w]|\.\d)/g)) {
    const digits = match[0].replaceAll(',', '');
    if (digits.includes('.') || digits.length >= 3) found(match.index, match[0]);
  }
}
