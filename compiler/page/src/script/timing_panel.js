// The timing diagram as it is used: which signals, which time, and the cursor.

import { bdi, byId, element } from './dom.js';
import { AXIS, LANE, namesWidth, paint } from './timing.js';
import { cell, shown } from './values.js';
import { duration } from './texts.js';

/** So many signals are shown until somebody chooses. */
const AT_FIRST = 24;
/** The time that is seen at first, and at least. */
const [SPAN, LEAST] = [20000, 20];

/** The panel below the drawing. */
export class TimingPanel {
  constructor(engine, settings) {
    Object.assign(this, { engine, settings });
    this.canvas = byId('timing').querySelector('canvas');
    this.follow = byId('follow');
    [this.from, this.span, this.cursor, this.anchor] = [0, SPAN, null, null];
    const known = settings.get('signals');
    this.chosen = new Set(known ?? engine.history.signals.slice(0, AT_FIRST).map((signal) => signal.key));
    this.listChoices();
    this.listen();
  }

  listChoices() {
    byId('signals').replaceChildren(...this.engine.history.signals.map((signal) => {
      const box = element('input', { type: 'checkbox' });
      box.checked = this.chosen.has(signal.key);
      box.addEventListener('change', () => {
        if (box.checked) this.chosen.add(signal.key);
        else this.chosen.delete(signal.key);
        this.settings.set('signals', [...this.chosen]);
        this.show();
      });
      return element('label', {}, box, bdi(shown(signal.name)));
    }));
  }

  get signals() {
    return this.engine.history.signals.filter((signal) => this.chosen.has(signal.key));
  }

  /** Paints it anew. */
  show() {
    const { canvas, engine } = this;
    const { end } = engine.history;
    if (this.follow.checked) this.from = Math.max(0, end - this.span * 0.92);
    const signals = this.signals;
    const width = canvas.clientWidth;
    const height = Math.max(canvas.parentElement.clientHeight, AXIS + signals.length * LANE + 2);
    const ratio = window.devicePixelRatio || 1;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
      canvas.style.height = `${height}px`;
    }
    const context = canvas.getContext('2d');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const { from, span, cursor, anchor } = this;
    paint(context, { width, height, from, to: from + span, end, signals, cursor, anchor, colours: this.colours() });
    this.tell(signals);
  }

  /** The colours of the page, asked for once a look. */
  colours() {
    const look = `${document.documentElement.dataset.theme} ${matchMedia('(prefers-color-scheme: dark)').matches} ${matchMedia('print').matches}`;
    if (this.look !== look) {
      this.look = look;
      const style = getComputedStyle(document.documentElement);
      const names = { panel: 'panel', ink: 'ink', soft: 'soft', hair: 'hair', accent: 'accent', active: 'active', fill: 'active-fill', acting: 'acting', forced: 'forced' };
      this.known = Object.fromEntries(Object.entries(names).map(([key, name]) => [key, style.getPropertyValue(`--${name}`).trim()]));
    }
    return this.known;
  }

  /** What is at the cursor, in words. */
  tell(signals) {
    const place = byId('cursor');
    if (this.cursor === null) {
      place.textContent = '';
      return;
    }
    const values = signals.map((signal) => {
      const at = signal.at(this.cursor);
      if (at < 0) return '';
      const value = signal.type === 'situation' ? `{${signal.values[at]}}` : cell(signal.values[at], signal.type);
      return `${shown(signal.name)} ${shown(value)}`;
    });
    const difference = this.anchor === null ? '' : ` (Δ ${duration(Math.abs(this.cursor - this.anchor))})`;
    place.textContent = `${duration(this.cursor)}${difference}: ${values.filter(Boolean).join(', ')}`;
  }

  /** The time at a place of the window. */
  timeAt(clientX) {
    const { left, width } = this.canvas.getBoundingClientRect();
    const names = namesWidth(width);
    const t = this.from + ((clientX - left - names) / (width - names)) * this.span;
    return Math.round(Math.min(Math.max(t, 0), this.engine.history.end));
  }

  /** Shows more or less around a time, by default the cursor or the middle. */
  zoom(factor, around = this.cursor ?? this.from + this.span / 2) {
    const span = Math.min(Math.max(this.span / factor, LEAST), Math.max(this.engine.history.end * 1.1, SPAN));
    if (!this.follow.checked) this.from = Math.max(0, around - ((around - this.from) * span) / this.span);
    this.span = span;
    this.show();
  }

  /** Shows everything. */
  all() {
    this.follow.checked = false;
    [this.from, this.span] = [0, Math.max(this.engine.history.end * 1.02, 1000)];
    this.show();
  }

  moveTo(t) {
    this.cursor = t;
    if (t !== null && (t < this.from || t > this.from + this.span)) {
      this.follow.checked = false;
      this.from = Math.max(0, t - this.span / 2);
    }
    this.show();
  }

  /** The next change of a signal that is shown, in a direction. */
  step(way) {
    const from = this.cursor ?? this.engine.history.end;
    let best = null;
    for (const signal of this.signals) {
      const at = signal.at(way > 0 ? from : from - 1);
      const t = signal.times[way > 0 ? at + 1 : at];
      if (t !== undefined && (best === null || (way > 0 ? t < best : t > best))) best = t;
    }
    if (best !== null) this.moveTo(best);
  }

  listen() {
    const { canvas } = this;
    canvas.addEventListener('wheel', (event) => {
      if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
        this.follow.checked = false;
        this.from = Math.max(0, this.from + ((event.deltaX || event.deltaY) / canvas.clientWidth) * this.span);
        this.show();
      } else {
        this.zoom(Math.exp(-event.deltaY * 0.0015), this.timeAt(event.clientX));
      }
      event.preventDefault();
    }, { passive: false });
    let held = null;
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      held = { x: event.clientX, from: this.from, isMoved: false };
    });
    canvas.addEventListener('pointermove', (event) => {
      if (held && Math.abs(event.clientX - held.x) > 4) held.isMoved = true;
      if (held?.isMoved) {
        this.follow.checked = false;
        this.from = Math.max(0, held.from - ((event.clientX - held.x) / (canvas.clientWidth - namesWidth(canvas.clientWidth))) * this.span);
        this.show();
      } else {
        this.cursor = this.timeAt(event.clientX);
        this.show();
      }
    });
    canvas.addEventListener('pointerup', (event) => {
      if (held && !held.isMoved) this.anchor = this.anchor === null ? this.timeAt(event.clientX) : null;
      held = null;
      this.show();
    });
    canvas.addEventListener('pointerleave', () => this.moveTo(null));
    canvas.addEventListener('keydown', (event) => {
      const keys = { ArrowLeft: () => this.step(-1), ArrowRight: () => this.step(1), Home: () => this.moveTo(0), End: () => this.moveTo(this.engine.history.end), '+': () => this.zoom(1.5), '-': () => this.zoom(1 / 1.5), Escape: () => this.moveTo(null) };
      if (!keys[event.key] || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      event.stopPropagation();
      keys[event.key]();
    });
    this.follow.addEventListener('change', () => this.show());
    new ResizeObserver(() => this.show()).observe(canvas.parentElement);
  }
}
