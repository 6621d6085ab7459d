// The words of the page in the language that is chosen.

const table = globalThis.document ? JSON.parse(document.getElementById('words-data').textContent) : {};
let language = 'en';
const listeners = [];

/** A word by its key, with what stands in its gaps: `word('step-named', { label: '1' })`. */
export function word(key, gaps = {}) {
  const entry = table[key];
  const text = entry ? entry[language] ?? entry.en : key;
  return text.replace(/\{(\w+)\}/g, (gap, name) => (Object.hasOwn(gaps, name) ? String(gaps[name]) : gap));
}

/** The language at hand. */
export function chosenLanguage() {
  return language;
}

/** Calls back whenever another language is chosen. */
export function onLanguage(listener) {
  listeners.push(listener);
}

/** Chooses a language, and writes it wherever the page has words of its own. */
export function chooseLanguage(chosen) {
  language = chosen;
  document.documentElement.lang = chosen;
  for (const element of document.querySelectorAll('[data-text]')) element.textContent = word(element.dataset.text);
  for (const element of document.querySelectorAll('[data-label]')) {
    const text = word(element.dataset.label);
    element.setAttribute('aria-label', text);
    if (element.localName === 'button') element.title = text;
  }
  listeners.forEach((listener) => listener());
}

/** A number of milliseconds as people read it: `1.250 s`, `2:03.500`. */
export function duration(ms) {
  const sign = language === 'de' ? ',' : '.';
  const whole = Math.floor(ms);
  const part = String(whole % 1000).padStart(3, '0');
  const seconds = Math.floor(whole / 1000);
  if (seconds < 60) return `${seconds}${sign}${part} s`;
  const two = (number) => String(number).padStart(2, '0');
  const minutes = Math.floor(seconds / 60);
  const clock = minutes < 60 ? `${minutes}` : `${Math.floor(minutes / 60)}:${two(minutes % 60)}`;
  return `${clock}:${two(seconds % 60)}${sign}${part}`;
}
