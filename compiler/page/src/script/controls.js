// The buttons of the page, each with a key of its own as long as no input has that key.

import { byId, mark } from './dom.js';
import { isTyping } from './keys.js';
import { word } from './texts.js';

/** Binds `data-control` to what it does. */
export function bind(actions, clock, keys) {
  const byKey = new Map();
  for (const button of document.querySelectorAll('[data-control]')) {
    const { control, key } = button.dataset;
    button.addEventListener('click', () => actions[control]());
    if (!key) continue;
    byKey.set(key, control);
    button.setAttribute('aria-keyshortcuts', key);
  }
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || isTyping(event) || keys.byKey.has(event.key)) return;
    const control = byKey.get(event.key);
    if (!control) return;
    event.preventDefault();
    actions[control]();
  });
}

/** Binds `data-setting` to the settings. */
export function bindSettings(settings) {
  for (const field of document.querySelectorAll('[data-setting]')) {
    const { setting } = field.dataset;
    field.value = String(settings.get(setting));
    field.addEventListener('change', () => {
      if (setting !== 'period') {
        settings.set(setting, field.value);
        return;
      }
      const period = Math.round(Number(field.value));
      if (period >= 1 && period <= 60000) settings.set('period', period);
      field.value = String(settings.get('period'));
    });
  }
}

/** What the buttons look like, and what they say of their keys. */
export function showControls(clock) {
  for (const button of document.querySelectorAll('[data-control]')) {
    const { control, key } = button.dataset;
    if (control === 'run') mark(button, 'aria-pressed', String(clock.isRunning));
    if (control === 'pause') mark(button, 'aria-disabled', String(!clock.isRunning));
    if (control === 'undo') mark(button, 'aria-disabled', String(!clock.engine.undos.length));
    if (key) button.title = word('tip', { what: word(`${control}`), key: key.toUpperCase() });
  }
}

/** A sentence for the user, read out as well. */
export function say(text) {
  const place = byId('say');
  place.textContent = text;
  clearTimeout(say.timer);
  if (text) say.timer = setTimeout(() => (place.textContent = ''), 6000);
}
