// A formula as one line of text: what is found, copied and read aloud where the drawing stands.

const digits = {sub: '₀₁₂₃₄₅₆₇₈₉', sup: '⁰¹²³⁴⁵⁶⁷⁸⁹'};
const spaced = /^[=<>≤≥≠≈±∓⇔⇒→∈⊕∑:]$|^(⋅|·|×|\+|−|-)$/;

// [a] for one letter or number, [(a + b)] for more.
const alone = (text) => /^[^\s/]+$/u.test(text) || /^\([^()]*\)$/.test(text) ? text : `(${text})`;
const raised = (text, kind) => /^\d+$/.test(text) ? [...text].map((digit) => digits[kind][+digit]).join('')
                               : (kind === 'sub' ? '_' : '^') + alone(text);
const prime = (text) => /^′+$/.test(text);

const written = {
  mfrac: ([above, below]) => `${alone(above)} / ${alone(below)}`,
  msqrt: (parts) => `√(${parts.join('')})`,
  msub: ([base, sub]) => base + raised(sub, 'sub'),
  msup: ([base, sup]) => base + (prime(sup) ? sup : raised(sup, 'sup')),
  msubsup: ([base, sub, sup]) => base + raised(sub, 'sub') + (prime(sup) ? sup : raised(sup, 'sup')),
  munder: ([base, under]) => under.trim() === '⏟' ? base : base + raised(under, 'sub'),  // a brace says nothing
  mover: ([base, over]) => base + over,
  munderover: ([base, under, over]) => base + raised(under, 'sub') + raised(over, 'sup'),
  mtr: (cells) => cells.join(' ') + '; ',
  mspace: () => ' ',
};

const operator = (text, isFirst) => !spaced.test(text) || isFirst ? text === ',' || text === ';' ? `${text} ` : text : ` ${text} `;

// The trees of the book keep entities as they are written.
const decoded = (text) => text.replace(/&#x([0-9a-f]+);/gi, (_, code) => String.fromCodePoint(parseInt(code, 16)))
    .replaceAll('&lt;', '<').replaceAll('&gt;', '>').replaceAll('&amp;', '&');

function linear(node, isFirst) {
  if (node.type === 'text') return decoded(node.data);
  const parts = node.children.map((child, i) => linear(child, i === 0));
  if (node.name === 'mo') return operator(parts.join('').trim().replace(/^[\u2061-\u2064]$/, ''), isFirst);
  const text = written[node.name]?.(parts) ?? parts.join('');
  return node.name === 'mtext' ? ` ${text} ` : text;
}

/// A <math> element as one line.
export const said = (math) => linear(math, true).replace(/[\s\u00a0]+/g, ' ').replace(/ ?; ?$/, '').trim();
