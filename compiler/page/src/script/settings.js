// What the user has chosen for the page, kept in the browser where it lets us.

const KEY = 'grafc-settings';

/** The choices, each with its usual value. */
export class Settings {
  constructor() {
    this.values = { speed: '1', period: 20, theme: 'auto', language: document.documentElement.lang, keys: [], signals: null };
    this.listeners = [];
    try {
      const kept = JSON.parse(localStorage.getItem(KEY) ?? '{}');
      // Keys and signals are of a chart; looks are of a person.
      if (['auto', 'light', 'dark'].includes(kept.theme)) this.values.theme = kept.theme;
    } catch {
      // A browser that keeps nothing for files.
    }
  }

  get(name) {
    return this.values[name];
  }

  set(name, value) {
    this.values[name] = value;
    try {
      localStorage.setItem(KEY, JSON.stringify({ theme: this.values.theme }));
    } catch {
      // As above.
    }
    this.listeners.forEach((listener) => listener(name, value));
  }

  onChange(listener) {
    this.listeners.push(listener);
  }
}
