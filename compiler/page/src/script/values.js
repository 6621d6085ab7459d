// Values as traces write them, and as they are shown.

/** The widths of whole numbers. */
const RANGES = {
  int: [-32768, 32767],
  dint: [-2147483648, 2147483647],
  uint: [0, 65535],
  udint: [0, 4294967295],
  time: [Number.MIN_SAFE_INTEGER, Number.MAX_SAFE_INTEGER],
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

const UNSEEN = /[\u0000-\u001f\u007f-\u009f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufffe\uffff]/g;

/** A text of the chart's as it is shown: marks that nobody sees, or that turn what follows, have a sign of their own. */
export function shown(text) {
  return text.replace(UNSEEN, (mark) => ('\n\t\r'.includes(mark) ? ' ' : '\ufffd'));
}
