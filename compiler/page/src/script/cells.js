// What a cell of a trace says: the values that `grafc sim` takes, and no others.

import { range } from './values.js';

const BLANK = /^\p{White_Space}$/u;

/** A text without the blanks around it. */
export function trimmed(text) {
  let [start, end] = [0, text.length];
  while (start < end && BLANK.test(text[start])) start += 1;
  while (start < end && BLANK.test(text[end - 1])) end -= 1;
  return text.slice(start, end);
}

/** What a cell says, as a value of the type; undefined if it says nothing of the kind. */
export function parsed(text, type) {
  const word = trimmed(text);
  if (type === 'bool') return truth(word);
  if (type === 'real' || type === 'lreal') return real(word, type);
  const number = whole(word) ?? (type === 'time' ? duration(word) : undefined);
  const [least, most] = range(type);
  return number !== undefined && number >= least && number <= most ? Number(number) : undefined;
}

function truth(word) {
  if (/^(?:1|true|wahr|vrai)$/i.test(word)) return true;
  return /^(?:0|false|falsch|faux)$/i.test(word) ? false : undefined;
}

/** Digits with `_` between two of them. */
const digits = (one) => `${one}+(?:_${one}+)*`;
const DECIMAL = digits('[0-9]');

const WHOLE = new RegExp(`^([-+]?)(?:(${DECIMAL})|2#(${digits('[01]')})|8#(${digits('[0-7]')})|16#(${digits('[0-9A-Fa-f]')}))$`);
const PREFIXES = ['', '0b', '0o', '0x'];

/** `3`, `-2`, `16#FF`, `1_000`: a whole number of 64 bits, exactly. */
function whole(word) {
  const match = WHOLE.exec(word);
  if (!match) return undefined;
  const base = [2, 3, 4, 5].findIndex((group) => match[group] !== undefined);
  const plain = match[base + 2].replaceAll('_', '').replace(/^0+(?=.)/, '');
  if (plain.length > 63) return undefined;
  const number = BigInt(PREFIXES[base] + plain);
  if (number >= 2n ** 63n) return undefined;
  return match[1] === '-' ? -number : number;
}

const BESIDE_NUMBERS = /^([-+]?)(?:(inf|infinity|1\.#inf)|nan|1\.#qnan|1\.#ind)$/i;
const REAL = /^[-+]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][-+]?[0-9]+)?$/;
/** As charts have it, with `_` between digits; it has a fraction or a power, or it is whole. */
const REAL_OF_CHARTS = new RegExp(`^[-+]?${DECIMAL}(?=[.eE])(?:\\.(?:${DECIMAL})?)?(?:[eE][-+]?${DECIMAL})?$`);

/** A number that the type holds: one that is too large is not taken for infinity. */
function real(word, type) {
  const beside = BESIDE_NUMBERS.exec(word);
  if (beside) return beside[2] ? Number(`${beside[1]}Infinity`) : NaN;
  const text = word.replace(',', '.');
  const exact = REAL.test(text) || REAL_OF_CHARTS.test(text) ? Number(text.replaceAll('_', '')) : whole(text);
  if (exact === undefined) return undefined;
  const number = type === 'real' ? Math.fround(Number(exact)) : Number(exact);
  return Number.isFinite(number) ? number : undefined;
}

const UNITS = { d: 86400000n, h: 3600000n, min: 60000n, s: 1000n, ms: 1n };
/** Those behind `T#`, in letters of either case. */
const UNITS_OF_IEC = { d: 86400000n, h: 3600000n, m: 60000n, s: 1000n, ms: 1n };

/** `1min30s`, `T#1m30s`: units from large to small, a fraction in the last alone, whole milliseconds, exactly. */
function duration(word) {
  const [, sign, iec, parts] = /^([-+]?)((?:T|TIME)#)?([^]*)$/i.exec(word);
  const part = new RegExp(`(${DECIMAL})(\\.(?:${DECIMAL})?)?([A-Za-z]+)(_*)`, 'y');
  let sum = 0n;
  let before = Infinity;
  let isLast = false;
  if (parts === '') return undefined;
  while (part.lastIndex < parts.length) {
    const match = part.exec(parts);
    if (!match || isLast) return undefined;
    const [, amount, fraction = '', letters, behind] = match;
    const isEnd = part.lastIndex === parts.length;
    const [units, name] = iec ? [UNITS_OF_IEC, letters.toLowerCase()] : [UNITS, letters];
    const unit = Object.hasOwn(units, name) ? units[name] : undefined;
    if (unit === undefined || unit >= before || (behind && (!iec || isEnd))) return undefined;
    const counted = amount.replaceAll('_', '').replace(/^0+(?=.)/, '');
    const decimals = fraction.slice(1).replaceAll('_', '').replace(/(?<!0)0+$/, '');
    // The longest has ten digits, and so has the finest fraction of a day that is whole milliseconds.
    if (counted.length > 10 || decimals.length > 10) return undefined;
    const share = BigInt(decimals) * unit;
    const whole = 10n ** BigInt(decimals.length);
    if (share % whole !== 0n) return undefined;
    sum += BigInt(counted) * unit + share / whole;
    [before, isLast] = [unit, fraction !== ''];
  }
  if (sum > 2147483647n) return undefined;
  return sign === '-' ? -sum : sum;
}
