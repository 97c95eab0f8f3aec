// Light or dark, the contents on a phone, a copy button at each listing, and one that stops what moves. The pages read
// well without it.
(() => {
  const page = document.documentElement, wish = 'first-contact-theme';
  const stored = () => { try { return localStorage.getItem(wish); } catch { return null; } };
  const system = matchMedia('(prefers-color-scheme: dark)');
  const isDark = () => (stored() ?? (system.matches ? 'dark' : 'light')) === 'dark';
  const show = () => {
    page.classList.toggle('dark-mode', isDark());
    page.classList.toggle('light-mode', !isDark());
    document.getElementById('theme')?.setAttribute('aria-pressed', String(isDark()));
  };
  show();
  system.addEventListener('change', show);

  const words = JSON.parse(document.getElementById('words').textContent);  // stands before this script

  const copyButton = (listing) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'copy';
    button.textContent = words.copy;
    button.title = words['copy this'];
    button.addEventListener('click', () => {
      const lines = [...listing.querySelectorAll('.line')].map((line) => line.textContent.replace(/\u00a0/g, ' '));
      navigator.clipboard?.writeText(lines.length ? lines.join('\n') : listing.textContent)
          .then(() => { button.textContent = words.copied; setTimeout(() => { button.textContent = words.copy; }, 1500); });
    });
    const frame = document.createElement('div');
    frame.className = 'with-copy';
    listing.replaceWith(frame);
    frame.append(listing, button);
  };

  const pauseButton = (picture) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'pause';
    button.title = words['pause or play'];
    button.textContent = words.pause;
    button.addEventListener('click', () => {
      const resume = picture.animationsPaused();
      resume ? picture.unpauseAnimations() : picture.pauseAnimations();
      button.textContent = resume ? words.pause : words.play;  // the picture it belongs to follows it
    });
    picture.before(button);
  };

  // A drawing that is wider than the page is scrolled, also by the keyboard.
  const reachable = new ResizeObserver((drawings) => {
    for (const {target: {parentElement: frame}} of drawings)
      frame.scrollWidth > frame.clientWidth ? frame.tabIndex = 0 : frame.removeAttribute('tabindex');
  });

  addEventListener('DOMContentLoaded', () => {
    show();
    document.getElementById('theme').addEventListener('click', () => {
      try { localStorage.setItem(wish, isDark() ? 'light' : 'dark'); } catch { /* then it lasts for this page alone */ }
      show();
    });
    const open = document.getElementById('open-contents');
    const toggle = (to) => {
      document.body.classList.toggle('contents-open', to);
      open.setAttribute('aria-expanded', String(document.body.classList.contains('contents-open')));
    };
    open.addEventListener('click', () => toggle());
    addEventListener('keydown', (event) => { if (event.key === 'Escape') toggle(false); });
    const unfold = () => {  // what a link leads to
      const target = document.querySelector('details:target');
      if (!target) return;
      target.open = true;
      target.scrollIntoView();
    };
    addEventListener('hashchange', unfold);
    unfold();
    document.querySelectorAll('div.fragment, pre.output, pre.shell').forEach(copyButton);
    document.querySelectorAll('svg.moves').forEach(pauseButton);
    document.querySelectorAll('.drawn > svg').forEach((drawing) => reachable.observe(drawing));
  });
})();
