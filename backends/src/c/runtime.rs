//! What a source needs at run time: functions that it holds itself, each only where it is called.
//!
//! Whole numbers wrap around at their width (as the language has it), by unsigned arithmetic: nothing overflows, and no
//! conversion is left to the compiler. The delay is the `Timer` of the crate `grafc-runtime`.

use super::names::CNames;
use crate::writer::Writer;
use rustc_hash::FxHashSet;

/// A function: its name, what it does where its name does not say it, and its text.
struct Helper {
    name: &'static str,
    about: &'static str,
    text: &'static str,
}

const fn helper(name: &'static str, about: &'static str, text: &'static str) -> Helper {
    Helper { name, about, text }
}

/// Sum, difference, product and negative of a type, which wrap around.
macro_rules! wrapping {
    ($word:literal, $ty:literal, $unsigned:literal, $to:literal, $end:literal) => {
        &[
            wrapping!(@of "add", "+", $word, $ty, $unsigned, $to, $end),
            wrapping!(@of "sub", "-", $word, $ty, $unsigned, $to, $end),
            wrapping!(@of "mul", "*", $word, $ty, $unsigned, $to, $end),
            helper(
                concat!("neg_", $word),
                "",
                concat!("static ", $ty, " neg_", $word, "(", $ty, " a)\n{\n    return ", $to, "0u - ", $unsigned, "a", $end, ";\n}"),
            ),
        ]
    };
    (@of $name:literal, $sign:literal, $word:literal, $ty:literal, $unsigned:literal, $to:literal, $end:literal) => {
        helper(
            concat!($name, "_", $word),
            "",
            concat!(
                "static ", $ty, " ", $name, "_", $word, "(", $ty, " a, ", $ty, " b)\n{\n    return ",
                $to, $unsigned, "a ", $sign, " ", $unsigned, "b", $end, ";\n}"
            ),
        )
    };
}

/// Quotient and remainder, as they are written.
macro_rules! division {
    ($word:literal, $ty:literal, $about:literal, $quotient:literal, $remainder:literal) => {
        &[
            division!(@of "div", $word, $ty, $about, $quotient),
            division!(@of "rem", $word, $ty, "", $remainder),
        ]
    };
    (@of $name:literal, $word:literal, $ty:literal, $about:literal, $value:literal) => {
        helper(
            concat!($name, "_", $word),
            concat!("by what is not 0", $about),
            concat!("static ", $ty, " ", $name, "_", $word, "(", $ty, " a, ", $ty, " b)\n{\n    return ", $value, ";\n}"),
        )
    };
}

/// A real number as its bits, and back.
macro_rules! bits {
    ($word:literal, $ty:literal, $bits:literal) => {
        &[
            // A number may have fewer bits than there is room for.
            bits!(@of concat!("bits_of_", $word), $bits, $ty, "value", "bits", "    both.bits = 0u;\n", $ty, $bits),
            bits!(@of concat!($word, "_of_bits"), $ty, $bits, "bits", "value", "", $ty, $bits),
        ]
    };
    (@of $name:expr, $to:literal, $from:literal, $given:literal, $asked:literal, $first:literal, $ty:literal, $bits:literal) => {
        helper(
            $name,
            "",
            concat!(
                "static ", $to, " ", $name, "(", $from, " ", $given, ")\n{\n    union {\n        ", $ty,
                " value;\n        ", $bits, " bits;\n    } both;\n\n", $first, "    both.", $given, " = ", $given,
                ";\n    return both.", $asked, ";\n}"
            ),
        )
    };
}

/// Bits as numbers.
const CONVERSIONS: &[Helper] = &[
    helper(
        "to_int",
        "16 bits as a number with a sign",
        "static int16_t to_int(uint32_t bits)
{
    const uint32_t low = bits & 0xFFFFu;
    const int32_t value = (int32_t)low;

    return (int16_t)(value > INT16_MAX ? value - 65535 - 1 : value);
}",
    ),
    helper(
        "to_dint",
        "32 bits as a number with a sign",
        "static int32_t to_dint(uint32_t bits)
{
    const uint32_t rest = UINT32_MAX - bits;

    return bits <= (uint32_t)INT32_MAX ? (int32_t)bits : -1 - (int32_t)rest;
}",
    ),
    helper(
        "to_uint",
        "the lowest 16 bits",
        "static uint16_t to_uint(uint32_t bits)
{
    return (uint16_t)(bits & 0xFFFFu);
}",
    ),
    helper(
        "to_time",
        "64 bits as a number with a sign",
        "static int64_t to_time(uint64_t bits)
{
    const uint64_t rest = UINT64_MAX - bits;

    return bits <= (uint64_t)INT64_MAX ? (int64_t)bits : -1 - (int64_t)rest;
}",
    ),
];

/// Delays.
const DELAYS: &[Helper] = &[
    helper(
        "delay_run",
        "brings a delay up to date with what it delays",
        "static void delay_run(CHART_delay *delay, bool input, uint32_t now_ms)
{
    if (!input) {
        delay->elapsed = 0;
    } else if (delay->running) {
        /* right across the end of the clock's range; more than half of that is a clock that was put back */
        const uint32_t passed = now_ms - delay->last;

        if (passed <= 0x80000000u && delay->elapsed <= INT64_MAX - (int64_t)passed) {
            delay->elapsed += (int64_t)passed;
        }
        delay->last = now_ms;
    } else {
        delay->elapsed = 0;
        delay->last = now_ms;
    }
    delay->running = input;
}",
    ),
    helper(
        "delay_has_run",
        "whether the time is over: it is from the very instant on",
        "static bool delay_has_run(const CHART_delay *delay, int64_t preset)
{
    return delay->running && delay->elapsed >= preset;
}",
    ),
];

/// Memory as bytes.
const MEMORY: &[Helper] = &[
    helper(
        "put",
        "the lowest bytes of a number, the lowest first; the place behind them",
        "static uint32_t put(uint8_t *bytes, uint32_t at, uint64_t value, uint32_t count)
{
    uint64_t rest = value;
    uint32_t place;

    for (place = at; place < at + count; place++) {
        bytes[place] = (uint8_t)(rest & 0xFFu);
        rest >>= 8;
    }
    return at + count;
}",
    ),
    helper(
        "put_state",
        "",
        "static uint32_t put_state(uint8_t *bytes, uint32_t at, int32_t state)
{
    return put(bytes, at, (uint32_t)state, 4u);
}",
    ),
    helper(
        "take",
        "a number of so many bytes, and on to the place behind them",
        "static uint64_t take(const uint8_t *bytes, uint32_t *at, uint32_t count)
{
    uint64_t value = 0u;
    uint32_t place;

    for (place = *at + count; place > *at; place--) {
        value = (value << 8) | bytes[place - 1u];
    }
    *at += count;
    return value;
}",
    ),
    helper(
        "take_bool",
        "",
        "static bool take_bool(const uint8_t *bytes, uint32_t *at, bool *is_right)
{
    const uint64_t value = take(bytes, at, 1u);

    *is_right = *is_right && value <= 1u;
    return value == 1u;
}",
    ),
    helper(
        "checksum",
        "CRC-32",
        "static uint32_t checksum(const uint8_t *bytes, uint32_t count)
{
    uint32_t sum = UINT32_MAX;
    uint32_t place;

    for (place = 0u; place < count; place++) {
        uint8_t bit;

        sum ^= bytes[place];
        for (bit = 0u; bit < 8u; bit++) {
            sum = (sum >> 1) ^ ((sum & 1u) != 0u ? 0xEDB88320u : 0u);
        }
    }
    return sum ^ UINT32_MAX;
}",
    ),
    helper(
        "sealed",
        "whether bytes end with their checksum",
        "static bool sealed(const uint8_t *bytes, uint32_t count)
{
    const uint32_t end = count - 4u;
    uint32_t at = end;

    return take(bytes, &at, 4u) == checksum(bytes, end);
}",
    ),
];

/// All of them, each behind those that it calls.
const HELPERS: &[&[Helper]] = &[
    CONVERSIONS,
    wrapping!("int", "int16_t", "(uint32_t)", "to_int(", ")"),
    wrapping!("dint", "int32_t", "(uint32_t)", "to_dint(", ")"),
    wrapping!("uint", "uint16_t", "(uint32_t)", "to_uint(", ")"),
    wrapping!("udint", "uint32_t", "", "", ""),
    wrapping!("time", "int64_t", "(uint64_t)", "to_time(", ")"),
    &[
        helper(
            "div_int",
            "by what is not 0",
            "static int16_t div_int(int16_t a, int16_t b)
{
    const int32_t quotient = (int32_t)a / (int32_t)b;

    return to_int((uint32_t)quotient);
}",
        ),
        helper(
            "rem_int",
            "by what is not 0",
            "static int16_t rem_int(int16_t a, int16_t b)
{
    return (int16_t)((int32_t)a % (int32_t)b);
}",
        ),
    ],
    division!(
        "dint",
        "int32_t",
        "; the least number divided by -1 wraps around to itself",
        "b == -1 ? to_dint(0u - (uint32_t)a) : a / b",
        "b == -1 ? 0 : a % b"
    ),
    division!("uint", "uint16_t", "", "to_uint((uint32_t)a / b)", "to_uint((uint32_t)a % b)"),
    division!("udint", "uint32_t", "", "a / b", "a % b"),
    division!(
        "time",
        "int64_t",
        "; the least number divided by -1 wraps around to itself",
        "b == -1 ? to_time(0u - (uint64_t)a) : a / b",
        "b == -1 ? 0 : a % b"
    ),
    DELAYS,
    MEMORY,
    bits!("real", "float", "uint32_t"),
    bits!("lreal", "double", "uint64_t"),
];

fn all() -> impl DoubleEndedIterator<Item = &'static Helper> {
    HELPERS.iter().copied().flatten()
}

/// Writes those that some code calls, and those that these call.
pub(super) fn write(out: &mut Writer, code: &str, names: &CNames) {
    let mut called = words(code);
    // Each calls those before it alone.
    for helper in all().rev() {
        if called.contains(helper.name) {
            called.extend(words(helper.text));
        }
    }
    let prefix = format!("{}_delay", names.chart);
    for helper in all().filter(|helper| called.contains(helper.name)) {
        out.blank();
        out.comment(helper.about);
        out.line(&helper.text.replace("CHART_delay", &prefix));
    }
}

/// The words of code that are neither in comments nor in strings.
fn words(code: &str) -> FxHashSet<&str> {
    let bytes = code.as_bytes();
    let mut found = FxHashSet::default();
    let mut at = 0;
    while at < bytes.len() {
        let start = at;
        match bytes[at] {
            b'/' if bytes.get(at + 1) == Some(&b'*') => {
                at = code[at + 2..].find("*/").map_or(bytes.len(), |end| at + 2 + end + 2);
            }
            b'"' => {
                at += 1;
                while at < bytes.len() && bytes[at] != b'"' {
                    at += if bytes[at] == b'\\' { 2 } else { 1 };
                }
                at += 1;
            }
            b'a'..=b'z' | b'A'..=b'Z' | b'_' => {
                while at < bytes.len() && (bytes[at].is_ascii_alphanumeric() || bytes[at] == b'_') {
                    at += 1;
                }
                found.insert(&code[start..at]);
            }
            _ => at += 1,
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_comments_and_strings_are_none() {
        let found = words("/* put (take) */ x = \"add_int(\\\"\" + sub_int(y); // */");
        assert!(["x", "sub_int", "y"].iter().all(|word| found.contains(word)));
        assert!(!["put", "take", "add_int"].iter().any(|word| found.contains(word)));
    }

    #[test]
    fn each_calls_those_before_it_alone() {
        for (place, helper) in all().enumerate() {
            assert!(
                helper.text.contains(&format!(" {}(", helper.name))
                    || helper.text.contains(&format!("*{}(", helper.name))
            );
            let later = all().skip(place + 1).find(|other| words(helper.text).contains(other.name));
            assert!(later.is_none(), "{} calls what stands behind it", helper.name);
        }
    }
}
