// The timing diagram as it is painted: a lane a signal, and over all the axis of time.

import { cell, shown } from './values.js';
import { duration } from './texts.js';

/** The height of a lane, of the axis, and the width of the names. */
export const LANE = 24;
export const AXIS = 20;
/** The part of a lane that is used, from its top. */
const [HIGH, LOW] = [5, 20];

/** From one mark of the axis to the next: what people count by. */
const DAY = 86400000;
const TICKS = [1, 2, 5, 10, 20, 50, 100, 200, 500, ...[1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 18000, 36000, 72000].map((s) => s * 1000), DAY];

/** The width that names take. */
export function namesWidth(width) {
  return Math.min(150, Math.floor(width * 0.28));
}

/** Paints signals between two times. */
export function paint(context, { width, height, from, to, end, signals, cursor, anchor, colours }) {
  const left = namesWidth(width);
  const scale = (width - left) / (to - from);
  const x = (t) => left + (t - from) * scale;
  context.fillStyle = colours.panel;
  context.fillRect(0, 0, width, height);
  context.font = '11px system-ui, sans-serif';
  context.textBaseline = 'middle';
  axis(context, { width, height, from, to, left, x, colours });
  context.save();
  context.beginPath();
  context.rect(left, AXIS, width - left, height);
  context.clip();
  const last = Math.min(to, end);
  signals.forEach((signal, place) => {
    const lane = { signal, top: AXIS + place * LANE, from, last, x, left, width, colours };
    if (signal.type === 'bool') levels(context, lane);
    else if (signal.type === 'situation') segments(context, lane);
    else curve(context, lane);
  });
  context.restore();
  names(context, { signals, left, cursor, colours, height });
  line(context, anchor, x, left, height, colours.soft, [3, 3]);
  line(context, cursor, x, left, height, colours.accent, []);
}

function axis(context, { width, height, from, to, left, x, colours }) {
  const wish = ((to - from) * 90) / (width - left);
  const tick = TICKS.find((step) => step >= wish) ?? Math.ceil(wish / DAY) * DAY;
  context.textAlign = 'center';
  for (let t = Math.max(0, Math.ceil(from / tick) * tick); t <= to; t += tick) {
    context.fillStyle = colours.hair;
    context.fillRect(Math.round(x(t)), AXIS, 1, height);
    context.fillStyle = colours.soft;
    if (x(t) > left + 20 && x(t) < width - 24) context.fillText(tick < 1000 ? duration(t) : duration(t).replace(/[.,]000/, ''), x(t), AXIS / 2);
  }
}

function names(context, { signals, left, cursor, colours, height }) {
  context.fillStyle = colours.panel;
  context.fillRect(0, 0, left, height);
  signals.forEach((signal, place) => {
    const middle = AXIS + place * LANE + LANE / 2;
    const at = cursor === null ? signal.values.length - 1 : signal.at(cursor);
    const value = at < 0 ? '' : signal.type === 'situation' ? '' : cell(signal.values[at], signal.type);
    context.textAlign = 'right';
    context.fillStyle = colours.accent;
    context.fillText(value, left - 6, middle);
    const room = left - 14 - context.measureText(value).width;
    context.textAlign = 'left';
    context.fillStyle = signal.kind === 'grafcet' ? colours.soft : colours.ink;
    context.fillText(fitted(context, shown(signal.name), room), 2, middle);
    context.fillStyle = colours.hair;
    context.fillRect(0, AXIS + (place + 1) * LANE - 1, left, 1);
  });
}

function line(context, t, x, left, height, colour, dash) {
  if (t === null || x(t) < left) return;
  context.save();
  context.strokeStyle = colour;
  context.setLineDash(dash);
  context.beginPath();
  context.moveTo(Math.round(x(t)) + 0.5, 0);
  context.lineTo(Math.round(x(t)) + 0.5, height);
  context.stroke();
  context.restore();
}

/** The pieces of a signal that are seen, as `[from, to, value]`; where more change than there are pixels, a pixel a piece. */
function* pieces({ signal, from, last, x, left, width }) {
  const first = Math.max(0, signal.at(from));
  const count = signal.at(last) - first;
  if (count <= (width - left) * 2) {
    for (let at = first; at < signal.times.length && signal.times[at] <= last; at++) {
      yield [Math.max(x(signal.times[at]), left - 2), x(Math.min(signal.times[at + 1] ?? last, last)), signal.values[at], at === first && signal.times[at] < from];
    }
    return;
  }
  const perPixel = (last - from) / (x(last) - left);
  let before = -1;
  for (let pixel = left; pixel <= x(last); pixel++) {
    const at = signal.at(from + (pixel - left) * perPixel);
    if (at < 0) continue;
    // Many changes within a pixel are a solid line.
    yield [pixel, pixel + 1, signal.values[at], false, at - before > 1];
    before = at;
  }
}

function levels(context, lane) {
  const { top, colours, signal } = lane;
  const colour = signal.kind === 'output' ? colours.acting : signal.kind === 'input' ? colours.accent : colours.active;
  context.strokeStyle = colour;
  context.lineWidth = 1.5;
  context.beginPath();
  let y = null;
  for (const [from, to, value, , isDense] of pieces(lane)) {
    const next = top + (value ? HIGH : LOW);
    if (y === null) context.moveTo(from, next);
    else context.lineTo(from, y);
    context.lineTo(from, next);
    if (isDense) {
      context.lineTo(from, top + HIGH);
      context.lineTo(from, top + LOW);
    }
    context.lineTo(to, next);
    y = next;
    if (value && to - from > 1) {
      context.save();
      context.globalAlpha = 0.14;
      context.fillStyle = colour;
      context.fillRect(from, top + HIGH, to - from, LOW - HIGH);
      context.restore();
    }
  }
  context.stroke();
  context.lineWidth = 1;
}

function segments(context, lane) {
  const { top, colours } = lane;
  context.textAlign = 'center';
  for (const [from, to, value, , isDense] of pieces(lane)) {
    context.fillStyle = isDense ? colours.soft : value ? colours.fill : colours.hair;
    context.fillRect(from, top + HIGH - 2, Math.max(to - from, 1), LOW - HIGH + 4);
    context.fillStyle = colours.soft;
    if (to - from > 2) context.fillRect(from, top + HIGH - 2, 1, LOW - HIGH + 4);
    label(context, shown(value), from, to, top, colours.active);
  }
}

function curve(context, lane) {
  const { top, colours, signal, from, last } = lane;
  let [low, high] = [Infinity, -Infinity];
  const [first, end] = [Math.max(0, signal.at(from)), signal.at(last)];
  const stride = Math.max(1, Math.floor((end - first) / 4000));
  for (let at = first; at <= end; at += stride) {
    const value = Number(signal.values[at]);
    if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
  }
  const y = (value) => top + LOW - (high > low && Number.isFinite(value) ? ((value - low) / (high - low)) * (LOW - HIGH) : 0);
  context.strokeStyle = colours.forced;
  context.beginPath();
  let before = null;
  const texts = [];
  for (const [start, stop, value] of pieces(lane)) {
    const next = y(Number(value));
    if (before === null) context.moveTo(start, next);
    else context.lineTo(start, before);
    context.lineTo(start, next);
    context.lineTo(stop, next);
    before = next;
    texts.push([cell(value, signal.type), start, stop]);
  }
  context.stroke();
  context.textAlign = 'center';
  if (texts.length < 400) for (const [text, start, stop] of texts) label(context, text, start, stop, top, colours.ink);
}

function label(context, text, from, to, top, colour) {
  const room = to - from - 8;
  if (room < 8 || !text) return;
  context.fillStyle = colour;
  const short = fitted(context, text, room);
  if (short !== '…') context.fillText(short, (from + to) / 2, top + (HIGH + LOW) / 2);
}

/** A text that is cut where there is no more room. */
function fitted(context, text, room) {
  if (context.measureText(text).width <= room) return text;
  let end = Math.min(text.length, Math.floor(room / 4));
  while (end > 0 && context.measureText(`${text.slice(0, end)}…`).width > room) end -= 1;
  return `${text.slice(0, end)}…`;
}
