// Values as traces write them, and as people do.

/** The widths of whole numbers. */
const RANGES = {
  int: [-32768, 32767],
  dint: [-2147483648, 2147483647],
  uint: [0, 65535],
  udint: [0, 4294967295],
  time: [0, 2147483647],
};

/** The least and the greatest value of a type; of a real there is none. */
export function range(type) {
  return RANGES[type] ?? [-Infinity, Infinity];
}

/** A value that JSON could not say as a number. */
export function revived(value) {
  if (value === 'inf') return Infinity;
  if (value === '-inf') return -Infinity;
  return value === 'NaN' ? NaN : value;
}

/** A value as `grafc sim` writes it: `0` and `1`, milliseconds, a real with as many digits as it takes. */
export function cell(value, type) {
  if (typeof value === 'boolean') return value ? '1' : '0';
  if (typeof value === 'bigint') return String(value);
  if (type === 'real' || type === 'lreal') return real(value, type);
  return String(value);
}

function real(value, type) {
  if (Number.isNaN(value)) return 'NaN';
  if (!Number.isFinite(value)) return value > 0 ? 'inf' : '-inf';
  let text = String(value);
  if (type === 'real') {
    // The shortest text that is read as the same single.
    for (let digits = 1; digits <= 9; digits++) {
      const shorter = value.toPrecision(digits);
      if (Math.fround(Number(shorter)) === value) {
        text = shorter;
        break;
      }
    }
  }
  if (Object.is(value, -0)) return '-0';
  return plain(text);
}

/** `1.5e-7` as `0.00000015`. */
function plain(text) {
  const match = /^(-?)(\d+)(?:\.(\d+))?e([+-]\d+)$/.exec(text);
  if (!match) return text.includes('.') ? text.replace(/\.?0+$/, '') : text;
  const [, sign, whole, part = '', power] = match;
  const digits = whole + part;
  const point = whole.length + Number(power);
  let out;
  if (point <= 0) out = `0.${'0'.repeat(-point)}${digits}`;
  else if (point >= digits.length) out = digits + '0'.repeat(point - digits.length);
  else out = `${digits.slice(0, point)}.${digits.slice(point)}`;
  return sign + (out.includes('.') ? out.replace(/\.?0+$/, '') : out);
}

/** Whether one value in the place of the other is no change. */
export function same(a, b) {
  return a === b || (a !== a && b !== b);
}

/** What a cell of a trace says, as a value of the type; undefined if it says nothing of the kind. */
export function parsed(text, type) {
  const word = text.trim();
  if (type === 'bool') return truth(word);
  if (type === 'real' || type === 'lreal') {
    const special = { inf: Infinity, '-inf': -Infinity, nan: NaN, infinity: Infinity, '-infinity': -Infinity }[word.toLowerCase()];
    if (special !== undefined) return special;
    const number = numeral(word, true);
    return number === undefined || type === 'lreal' ? number : Math.fround(number);
  }
  const number = type === 'time' ? (span(word) ?? numeral(word, false)) : numeral(word, false);
  const [least, most] = range(type);
  return number !== undefined && number >= least && number <= most ? number : undefined;
}

function truth(word) {
  if (['1', 'TRUE', 'WAHR', 'VRAI'].includes(word.toUpperCase())) return true;
  return ['0', 'FALSE', 'FALSCH', 'FAUX'].includes(word.toUpperCase()) ? false : undefined;
}

function numeral(word, isReal) {
  const digits = word.replace(/(?<=[0-9A-Fa-f])_(?=[0-9A-Fa-f])/g, '');
  const based = /^(-?)(2|8|16)#([0-9A-Fa-f]+)$/.exec(digits);
  if (based) {
    const number = parseInt(based[3], Number(based[2]));
    return based[1] ? -number : number;
  }
  const form = isReal ? /^[-+]?\d+(?:[.,]\d+)?(?:[eE][-+]?\d+)?$/ : /^[-+]?\d+$/;
  return form.test(digits) ? Number(digits.replace(',', '.')) : undefined;
}

/** `1min30s`, `T#500ms`. */
function span(word) {
  const text = word.replace(/^(?:T|TIME)#/i, '').toLowerCase();
  const units = { d: 86400000, h: 3600000, min: 60000, m: 60000, s: 1000, ms: 1 };
  const parts = [...text.matchAll(/(\d+(?:[.,]\d+)?)(ms|min|d|h|m|s)/g)];
  if (!parts.length || parts.map((part) => part[0]).join('') !== text) return undefined;
  const sum = parts.reduce((sum, [, number, unit]) => sum + Number(number.replace(',', '.')) * units[unit], 0);
  return Number.isInteger(sum) ? sum : undefined;
}

const UNSEEN = /[\u0000-\u001f\u007f-\u009f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufffe\uffff]/g;

/** A text of the chart's as it is shown: marks that nobody sees, or that turn what follows, have a sign of their own. */
export function shown(text) {
  return text.replace(UNSEEN, (mark) => ('\n\t\r'.includes(mark) ? ' ' : '\ufffd'));
}
