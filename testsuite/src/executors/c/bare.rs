//! The C program that plays a trace where there is no operating system. It prints, on a serial line, what the program of
//! this machine prints; inputs are written into the code as they change, since tables would not fit into the memory of an
//! AVR. There are no real numbers.

use super::driver::{CALLS_BETWEEN_SAVES, START, literal};
use crate::executors::jobs::{flag_name, flags, outputs};
use grafc_backends::c::names;
use grafc_logic::scan::{Program, Role};
use grafc_model::chart::Value;
use grafc_model::reaction::Stimulus;
use std::fmt::Write as _;

/// Where things lie on the board with a Cortex-M.
pub(super) const SECTIONS: &str = "\
MEMORY { FLASH (rx) : ORIGIN = 0, LENGTH = 256K  RAM (rw) : ORIGIN = 0x20000000, LENGTH = 64K }
SECTIONS {
  .text : { KEEP(*(.vectors)) *(.text*) *(.rodata*) } > FLASH
  .bss : { *(.data*) *(.bss*) *(COMMON) } > RAM
}
ENTRY(main)
";

/// What the program calls on an AVR.
pub(super) const AVR: &str = "\
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

static void begin(void)
{
    UCSR0B = 1u << TXEN0;
}

static void put_char(char c)
{
    while ((UCSR0A & (1u << UDRE0)) == 0u) {
    }
    UDR0 = (uint8_t)c;
}

/* The emulator ends where nothing can wake the processor. */
static void end(void)
{
    cli();
    sleep_mode();
}
";

/// What it calls on the board with a Cortex-M.
pub(super) const CORTEX_M: &str = "\
#include <stddef.h>

int main(void);
void *memcpy(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);

void *memcpy(void *to, const void *from, size_t count)
{
    size_t place;

    for (place = 0; place < count; place++) {
        ((char *)to)[place] = ((const char *)from)[place];
    }
    return to;
}

void *memset(void *to, int value, size_t count)
{
    size_t place;

    for (place = 0; place < count; place++) {
        ((char *)to)[place] = (char)value;
    }
    return to;
}

/* The stack, and where to begin. */
__attribute__((section(\".vectors\"), used)) static const uintptr_t vectors[] = { 0x20010000u, (uintptr_t)main };

static void begin(void)
{
}

static void put_char(char c)
{
    *(volatile uint32_t *)0x4000C000u = (uint8_t)c;
}

/* Tells the emulator to end. */
static void end(void)
{
    register uint32_t call __asm__(\"r0\") = 0x18u;
    register uint32_t reason __asm__(\"r1\") = 0x20026u;

    __asm__ volatile(\"bkpt 0xAB\" : : \"r\"(call), \"r\"(reason));
}
";

const NUMBERS: &str = "
static void put_number(int64_t value)
{
    uint64_t rest = value < 0 ? 0u - (uint64_t)value : (uint64_t)value;
    char digits[20];
    uint8_t count = 0;

    put_char(' ');
    if (value < 0) {
        put_char('-');
    }
    do {
        digits[count] = (char)('0' + (char)(rest % 10u));
        rest /= 10u;
        count++;
    } while (rest > 0u);
    while (count > 0u) {
        count--;
        put_char(digits[count]);
    }
}

static void put_text(const char *text)
{
    while (*text != '\\0') {
        put_char(*text);
        text++;
    }
}
";

/// The program that plays the job 0, with the functions of a board.
pub(super) fn write(program: &Program, stimuli: &[Stimulus], on_board: &str) -> String {
    let names = names(program);
    let (chart, capitals) = (&names.chart, &names.capitals);
    let mut out = format!(
        "#include \"Job_0.h\"\n{on_board}{NUMBERS}
static {chart} chart;
static {chart} again;
static {chart}_inputs inputs;
static uint8_t bytes[{capitals}_SAVED_LEN];

static void play(int64_t row, uint32_t now_ms)
{{
    const {chart}_outputs *outputs = {chart}_scan(&chart, &inputs, now_ms);
    uint16_t step;

    put_char('0');
    put_number(row);
"
    );
    for (id, _) in outputs(program) {
        let _ = writeln!(out, "    put_number(outputs->{});", names.variables[id]);
    }
    let _ = writeln!(
        out,
        "    for (step = 0; step < {capitals}_STEP_COUNT; step++) {{
        put_number({chart}_is_active(&chart, ({chart}_step)step));
    }}"
    );
    for (_, flag) in flags(program) {
        let _ = writeln!(out, "    put_number(chart.flags.{});", flag_name(flag));
    }
    let _ = writeln!(
        out,
        "    put_char('\\n');
    if (row % {CALLS_BETWEEN_SAVES} == 1) {{
        {chart}_save(&chart, bytes);
        if (!{chart}_restore(&again, bytes, now_ms)) {{
            put_text(\"what was saved is refused\\n\");
        }}
        chart = again;
    }}
}}

int main(void)
{{
    begin();
    {chart}_init(&chart);
    {chart}_init_inputs(&inputs);"
    );
    let inputs: Vec<_> = program.variables.iter_enumerated().filter(|(_, v)| v.role == Role::Input).collect();
    let anew = if program.variables.iter().any(|variable| variable.retain) { "restart" } else { "init" };
    let mut before: Vec<Option<Value>> = inputs.iter().map(|_| None).collect();
    for (row, stimulus) in stimuli.iter().enumerate() {
        if stimulus.restart {
            let _ = writeln!(out, "    {chart}_{anew}(&chart);");
        }
        for (place, (id, variable)) in inputs.iter().enumerate() {
            if before[place].replace(stimulus.inputs[place]) != Some(stimulus.inputs[place]) {
                let value = literal(stimulus.inputs[place], variable.ty);
                let _ = writeln!(out, "    inputs.{} = {value};", names.variables[*id]);
            }
        }
        let _ = writeln!(out, "    play({row}, UINT32_C({}));", START.wrapping_add(stimulus.t_ms as u32));
    }
    out.push_str("    end();\n    for (;;) {\n    }\n}\n");
    out
}
