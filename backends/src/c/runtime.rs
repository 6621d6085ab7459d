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

/// All of them, each behind those that it calls.
const HELPERS: &[Helper] = &[
    helper(
        "to_int",
        "16 bits as a number with a sign",
        "static int16_t to_int(uint32_t bits)
{
    const int32_t value = (int32_t)(bits & 0xFFFFu);

    return (int16_t)(value > INT16_MAX ? value - 65535 - 1 : value);
}",
    ),
    helper(
        "to_dint",
        "32 bits as a number with a sign",
        "static int32_t to_dint(uint32_t bits)
{
    return bits <= (uint32_t)INT32_MAX ? (int32_t)bits : -1 - (int32_t)(UINT32_MAX - bits);
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
    return bits <= (uint64_t)INT64_MAX ? (int64_t)bits : -1 - (int64_t)(UINT64_MAX - bits);
}",
    ),
    helper(
        "add_int",
        "",
        "static int16_t add_int(int16_t a, int16_t b)
{
    return to_int((uint32_t)a + (uint32_t)b);
}",
    ),
    helper(
        "sub_int",
        "",
        "static int16_t sub_int(int16_t a, int16_t b)
{
    return to_int((uint32_t)a - (uint32_t)b);
}",
    ),
    helper(
        "mul_int",
        "",
        "static int16_t mul_int(int16_t a, int16_t b)
{
    return to_int((uint32_t)a * (uint32_t)b);
}",
    ),
    helper(
        "div_int",
        "by what is not 0",
        "static int16_t div_int(int16_t a, int16_t b)
{
    return to_int((uint32_t)((int32_t)a / (int32_t)b));
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
    helper(
        "neg_int",
        "",
        "static int16_t neg_int(int16_t a)
{
    return to_int(0u - (uint32_t)a);
}",
    ),
    helper(
        "add_dint",
        "",
        "static int32_t add_dint(int32_t a, int32_t b)
{
    return to_dint((uint32_t)a + (uint32_t)b);
}",
    ),
    helper(
        "sub_dint",
        "",
        "static int32_t sub_dint(int32_t a, int32_t b)
{
    return to_dint((uint32_t)a - (uint32_t)b);
}",
    ),
    helper(
        "mul_dint",
        "",
        "static int32_t mul_dint(int32_t a, int32_t b)
{
    return to_dint((uint32_t)a * (uint32_t)b);
}",
    ),
    helper(
        "neg_dint",
        "",
        "static int32_t neg_dint(int32_t a)
{
    return to_dint(0u - (uint32_t)a);
}",
    ),
    helper(
        "div_dint",
        "by what is not 0; the least number divided by -1 wraps around to itself",
        "static int32_t div_dint(int32_t a, int32_t b)
{
    return b == -1 ? to_dint(0u - (uint32_t)a) : a / b;
}",
    ),
    helper(
        "rem_dint",
        "by what is not 0",
        "static int32_t rem_dint(int32_t a, int32_t b)
{
    return b == -1 ? 0 : a % b;
}",
    ),
    helper(
        "add_uint",
        "",
        "static uint16_t add_uint(uint16_t a, uint16_t b)
{
    return to_uint((uint32_t)a + b);
}",
    ),
    helper(
        "sub_uint",
        "",
        "static uint16_t sub_uint(uint16_t a, uint16_t b)
{
    return to_uint((uint32_t)a - b);
}",
    ),
    helper(
        "mul_uint",
        "",
        "static uint16_t mul_uint(uint16_t a, uint16_t b)
{
    return to_uint((uint32_t)a * b);
}",
    ),
    helper(
        "div_uint",
        "by what is not 0",
        "static uint16_t div_uint(uint16_t a, uint16_t b)
{
    return to_uint((uint32_t)a / b);
}",
    ),
    helper(
        "rem_uint",
        "by what is not 0",
        "static uint16_t rem_uint(uint16_t a, uint16_t b)
{
    return to_uint((uint32_t)a % b);
}",
    ),
    helper(
        "neg_uint",
        "",
        "static uint16_t neg_uint(uint16_t a)
{
    return to_uint(0u - (uint32_t)a);
}",
    ),
    helper(
        "add_udint",
        "",
        "static uint32_t add_udint(uint32_t a, uint32_t b)
{
    return a + b;
}",
    ),
    helper(
        "sub_udint",
        "",
        "static uint32_t sub_udint(uint32_t a, uint32_t b)
{
    return a - b;
}",
    ),
    helper(
        "mul_udint",
        "",
        "static uint32_t mul_udint(uint32_t a, uint32_t b)
{
    return a * b;
}",
    ),
    helper(
        "div_udint",
        "by what is not 0",
        "static uint32_t div_udint(uint32_t a, uint32_t b)
{
    return a / b;
}",
    ),
    helper(
        "rem_udint",
        "by what is not 0",
        "static uint32_t rem_udint(uint32_t a, uint32_t b)
{
    return a % b;
}",
    ),
    helper(
        "neg_udint",
        "",
        "static uint32_t neg_udint(uint32_t a)
{
    return 0u - a;
}",
    ),
    helper(
        "add_time",
        "",
        "static int64_t add_time(int64_t a, int64_t b)
{
    return to_time((uint64_t)a + (uint64_t)b);
}",
    ),
    helper(
        "sub_time",
        "",
        "static int64_t sub_time(int64_t a, int64_t b)
{
    return to_time((uint64_t)a - (uint64_t)b);
}",
    ),
    helper(
        "mul_time",
        "",
        "static int64_t mul_time(int64_t a, int64_t b)
{
    return to_time((uint64_t)a * (uint64_t)b);
}",
    ),
    helper(
        "neg_time",
        "",
        "static int64_t neg_time(int64_t a)
{
    return to_time(0u - (uint64_t)a);
}",
    ),
    helper(
        "div_time",
        "by what is not 0; the least number divided by -1 wraps around to itself",
        "static int64_t div_time(int64_t a, int64_t b)
{
    return b == -1 ? to_time(0u - (uint64_t)a) : a / b;
}",
    ),
    helper(
        "rem_time",
        "by what is not 0",
        "static int64_t rem_time(int64_t a, int64_t b)
{
    return b == -1 ? 0 : a % b;
}",
    ),
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

        if (passed <= UINT32_C(0x80000000) && delay->elapsed <= INT64_MAX - (int64_t)passed) {
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
    helper(
        "put",
        "the lowest bytes of a number, the lowest first; what stands behind them",
        "static uint8_t *put(uint8_t *out, uint64_t value, uint8_t count)
{
    uint8_t place;

    for (place = 0u; place < count; place++) {
        out[place] = (uint8_t)((value >> (8u * place)) & 0xFFu);
    }
    return out + count;
}",
    ),
    helper(
        "put_state",
        "",
        "static uint8_t *put_state(uint8_t *out, int32_t state)
{
    return put(out, (uint32_t)state, 4u);
}",
    ),
    helper(
        "take",
        "a number of so many bytes, and on to what stands behind them",
        "static uint64_t take(const uint8_t **from, uint8_t count)
{
    uint64_t value = 0u;
    uint8_t place;

    for (place = 0u; place < count; place++) {
        value |= (uint64_t)(*from)[place] << (8u * place);
    }
    *from += count;
    return value;
}",
    ),
    helper(
        "take_bool",
        "",
        "static bool take_bool(const uint8_t **from, bool *is_right)
{
    const uint64_t value = take(from, 1u);

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
            sum = (sum >> 1) ^ ((sum & 1u) != 0u ? UINT32_C(0xEDB88320) : 0u);
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
    const uint8_t *end = bytes + (count - 4u);

    return take(&end, 4u) == checksum(bytes, count - 4u);
}",
    ),
    helper(
        "bits_of_real",
        "",
        "static uint32_t bits_of_real(float value)
{
    union {
        float value;
        uint32_t bits;
    } both;

    both.value = value;
    return both.bits;
}",
    ),
    helper(
        "real_of_bits",
        "",
        "static float real_of_bits(uint32_t bits)
{
    union {
        float value;
        uint32_t bits;
    } both;

    both.bits = bits;
    return both.value;
}",
    ),
    helper(
        "bits_of_lreal",
        "",
        "static uint64_t bits_of_lreal(double value)
{
    union {
        double value;
        uint64_t bits;
    } both;

    both.bits = 0u;
    both.value = value;
    return both.bits;
}",
    ),
    helper(
        "lreal_of_bits",
        "",
        "static double lreal_of_bits(uint64_t bits)
{
    union {
        double value;
        uint64_t bits;
    } both;

    both.bits = bits;
    return both.value;
}",
    ),
];

/// Writes those that some code calls, and those that these call.
pub(super) fn write(out: &mut Writer, code: &str, names: &CNames) {
    let mut called = words(code);
    // Each calls those before it alone.
    for helper in HELPERS.iter().rev() {
        if called.contains(helper.name) {
            called.extend(words(helper.text));
        }
    }
    let prefix = format!("{}_delay", names.chart);
    for helper in HELPERS.iter().filter(|helper| called.contains(helper.name)) {
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
        for (place, helper) in HELPERS.iter().enumerate() {
            assert!(
                helper.text.contains(&format!(" {}(", helper.name))
                    || helper.text.contains(&format!("*{}(", helper.name))
            );
            let later = HELPERS[place + 1..].iter().find(|other| words(helper.text).contains(other.name));
            assert!(later.is_none(), "{} calls what stands behind it", helper.name);
        }
    }
}
