//! The C program that checks and times one spelling, as that in Rust does: the scan is called through a pointer that the
//! compiler cannot see through, and the same loop without a call is subtracted.

use super::super::driver::{CHECKED, SLICES};
use crate::rings::Rings;
use std::fmt::Write as _;

const BODY: &str = r#"
static Ring chart;
static Ring_inputs inputs;
static uint32_t now_ms;
/* The place of the tokens in their rings. */
static uint32_t at;
static const Ring_outputs *(*volatile scan)(Ring *, const Ring_inputs *, uint32_t) = Ring_scan;
static const Ring_inputs *volatile given = &inputs;

static void put(uint32_t step, bool value)
{
    *(bool *)((char *)&inputs + INPUTS[step]) = value;
}

static bool output(uint32_t step)
{
    return *(const bool *)((const char *)&chart.outputs + OUTPUTS[step]);
}

static inline void once(bool scans)
{
    const Ring_inputs *from = given;

    if (scans) {
        (void)scan(&chart, from, now_ms);
    }
    now_ms++;
}

static uint32_t next(void)
{
    return at + 1u == WALKED ? 0u : at + 1u;
}

static inline void idle_of(uint64_t times, bool scans)
{
    while (times-- > 0u) {
        once(scans);
    }
}

static inline void clearing_of(uint64_t times, bool scans)
{
    uint32_t ring;

    while (times-- > 0u) {
        for (ring = 0u; ring < RINGS; ring++) {
            put(ring * LENGTH + at, true);
        }
        once(scans);
        for (ring = 0u; ring < RINGS; ring++) {
            put(ring * LENGTH + at, false);
        }
        at = next();
    }
}

static void idle(uint64_t times) { idle_of(times, true); }
static void around_idle(uint64_t times) { idle_of(times, false); }
static void clearing(uint64_t times) { clearing_of(times, true); }
static void around_clearing(uint64_t times) { clearing_of(times, false); }

/* Each output is on if a token is at its step. */
static void compare(const char *when)
{
    uint32_t step;

    for (step = 0u; step < STEPS; step++) {
        if (output(step) != (step % LENGTH == at)) {
            fprintf(stderr, "%s, tokens at %u: output %u\n", when, (unsigned)at, (unsigned)step);
            exit(1);
        }
    }
}

/* Moves the tokens, with all inputs on but those of the steps that they come to. */
static void clearing_among_others(void)
{
    const uint32_t to = next();
    uint32_t step;

    for (step = 0u; step < STEPS; step++) {
        put(step, step % LENGTH != to);
    }
    once(true);
    at = to;
    compare("among others");
    for (step = 0u; step < STEPS; step++) {
        put(step, false);
    }
}

static double now(void)
{
    struct timespec time;

    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec * 1e9 + (double)time.tv_nsec;
}

static double timed(void (*what)(uint64_t), uint64_t times)
{
    const double begin = now();

    what(times);
    return now() - begin;
}

/* Ns a scan: the least of some short slices, because all that comes in between makes a slice longer. */
static double least(void (*what)(uint64_t))
{
    uint64_t times = 1u;
    double best = timed(what, times);
    int slice;

    while (best < 1e6) {
        times *= 2u;
        best = timed(what, times);
    }
    for (slice = 0; slice < SLICES; slice++) {
        const double taken = timed(what, times);

        best = taken < best ? taken : best;
    }
    return best / (double)times;
}

static double cost(void (*what)(uint64_t), void (*around)(uint64_t))
{
    const double all = least(what);
    /* Without scans the tokens do not move. */
    const uint32_t before = at;
    const double less = least(around);

    at = before;
    return all - less;
}

int main(void)
{
    int cleared;
    double nothing;
    double moves;

    Ring_init(&chart);
    idle(2u);
    compare("at the start");
    for (cleared = 0; cleared < CHECKED; cleared++) {
        if (cleared % 2 == 0) {
            clearing(1u);
        } else {
            clearing_among_others();
        }
        idle(1u);
        compare("after a clearing");
    }
    nothing = cost(idle, around_idle);
    moves = cost(clearing, around_clearing);
    compare("at the end");
    printf("%.4f %.4f %lu\n", nothing, moves, (unsigned long)sizeof chart);
    return 0;
}
"#;

/// The program, beside `chart.h`.
pub(super) fn write(rings: Rings) -> String {
    let mut out = String::from(
        "#define _POSIX_C_SOURCE 199309L\n#include \"chart.h\"\n#include <stddef.h>\n#include <stdio.h>\n\
         #include <stdlib.h>\n#include <time.h>\n\n",
    );
    let (steps, tokens, length) = (rings.steps, rings.tokens, rings.length());
    for (name, value) in [("STEPS", steps), ("RINGS", tokens), ("LENGTH", length), ("WALKED", rings.walked)] {
        let _ = writeln!(out, "#define {name} {value}u");
    }
    let _ = writeln!(out, "#define SLICES {SLICES}\n#define CHECKED {CHECKED}");
    for (name, of, letter) in [("INPUTS", "Ring_inputs", 'x'), ("OUTPUTS", "Ring_outputs", 'w')] {
        let _ = writeln!(out, "\n/* Where each field lies. */\nstatic const size_t {name}[STEPS] = {{");
        for i in 0..rings.steps {
            let _ = writeln!(out, "    offsetof({of}, {letter}_{i}),");
        }
        out.push_str("};\n");
    }
    out.push_str(BODY);
    out
}
