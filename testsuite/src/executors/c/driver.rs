//! The C code that plays traces and prints what [`crate::executors::jobs`] reads.

use crate::executors::jobs::{flag_name, flags, outputs};
use grafc_backends::c::{CNames, type_name};
use grafc_logic::scan::{Flag, Program, Role};
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::Stimulus;
use std::fmt::Write as _;

/// What stands before all functions that play.
pub(super) const HEAD: &str = "\
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void must(bool is, const char *what)
{
    if (!is) {
        fprintf(stderr, \"%s\\n\", what);
        exit(1);
    }
}
";

/// Clocks start here, so that they wrap around within a trace.
pub(super) const START: u32 = u32::MAX - 1500;

/// So many calls after the last, the chart is saved and restored.
pub(super) const CALLS_BETWEEN_SAVES: usize = 3;

/// The name of a job's chart.
pub(super) fn chart(index: usize) -> String {
    format!("Job_{index}")
}

/// The file of its header.
pub(super) fn header(index: usize) -> String {
    format!("{}.h", chart(index))
}

/// The function that plays one job.
pub(super) fn write(index: usize, program: &Program, names: &CNames, stimuli: &[Stimulus]) -> String {
    let (chart, capitals) = (&names.chart, &names.capitals);
    let mut out = format!("\n#include \"{}\"\n\nstatic void play_{index}(void)\n{{\n", header(index));
    let column = |out: &mut String, ty: &str, name: &str, values: Vec<String>| {
        let _ = writeln!(out, "    static const {ty} {name}[] = {{ {} }};", values.join(", "));
    };
    let times = stimuli.iter().map(|stimulus| format!("UINT32_C({})", START.wrapping_add(stimulus.t_ms as u32)));
    column(&mut out, "uint32_t", "times", times.collect());
    let has_restarts = stimuli.iter().any(|stimulus| stimulus.restart);
    if has_restarts {
        column(&mut out, "bool", "restarts", stimuli.iter().map(|stimulus| stimulus.restart.to_string()).collect());
    }
    let inputs: Vec<_> = program.variables.iter_enumerated().filter(|(_, v)| v.role == Role::Input).collect();
    for (place, (_, variable)) in inputs.iter().enumerate() {
        let values = stimuli.iter().map(|stimulus| literal(stimulus.inputs[place], variable.ty)).collect();
        column(&mut out, type_name(variable.ty), &format!("in_{place}"), values);
    }
    let _ = writeln!(
        out,
        "    static {chart} chart;
    static {chart} again;
    static uint8_t bytes[{capitals}_SAVED_LEN];
    static uint8_t other[{capitals}_SAVED_LEN];
    {chart}_inputs inputs;
    size_t row;

    /* Memory is what it is: nothing in it may be relied on. */
    memset(&chart, 0xA5, sizeof chart);
    {chart}_init(&chart);
    {chart}_init_inputs(&inputs);
    for (row = 0; row < {}; row++) {{
        const {chart}_outputs *outputs;
        uint32_t step;
",
        stimuli.len()
    );
    if has_restarts {
        let anew = if program.variables.iter().any(|variable| variable.retain) { "restart" } else { "init" };
        let _ = writeln!(out, "        if (restarts[row]) {{\n            {chart}_{anew}(&chart);\n        }}");
    }
    for (place, (id, _)) in inputs.iter().enumerate() {
        let _ = writeln!(out, "        inputs.{} = in_{place}[row];", names.variables[*id]);
    }
    let _ = writeln!(out, "        outputs = {chart}_scan(&chart, &inputs, times[row]);");
    let _ = writeln!(out, "        must(outputs == &chart.outputs, \"outputs\");");
    let _ = writeln!(out, "        printf(\"{index} %u\", (unsigned)row);");
    for (id, variable) in outputs(program) {
        let _ = writeln!(out, "        {};", printed(variable.ty, &format!("outputs->{}", names.variables[id])));
    }
    let _ = writeln!(
        out,
        "        for (step = 0; step < {capitals}_STEP_COUNT; step++) {{
            printf(\" %d\", {chart}_is_active(&chart, ({chart}_step)step) ? 1 : 0);
        }}"
    );
    let mut never = vec![Flag::Livelock, Flag::AllocConflict, Flag::ForceConflict, Flag::Div0];
    for (_, flag) in flags(program) {
        never.retain(|other| *other != flag);
        let _ = writeln!(out, "        printf(\" %d\", chart.flags.{} ? 1 : 0);", flag_name(flag));
    }
    for flag in never {
        let _ = writeln!(out, "        must(!chart.flags.{0}, \"{0}\");", flag_name(flag));
    }
    let _ = writeln!(
        out,
        "        printf(\"\\n\");
        if (row % {CALLS_BETWEEN_SAVES} == 1) {{
            {chart}_save(&chart, bytes);
            must({chart}_restore(&again, bytes, times[row]), \"what was saved\");
            {chart}_save(&again, other);
            must(memcmp(bytes, other, sizeof bytes) == 0, \"saved again\");"
    );
    for (id, variable) in outputs(program) {
        let name = &names.variables[id];
        let is_nan = match variable.ty {
            Type::Real | Type::Lreal => format!(" || isnan(again.outputs.{name})"),
            Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => String::new(),
        };
        let _ = writeln!(out, "            must(again.outputs.{name} == chart.outputs.{name}{is_nan}, \"outputs\");");
    }
    let _ = writeln!(
        out,
        "            bytes[row % sizeof bytes] ^= (uint8_t)(1u << (row % 8u));
            must(!{chart}_restore(&chart, bytes, times[row]), \"one bit is another\");
            chart = again;
        }}
    }}
}}"
    );
    out
}

/// The end of the program: plays all jobs of a batch.
pub(super) fn main(batch: &[usize]) -> String {
    let calls: String = batch.iter().map(|index| format!("    play_{index}();\n")).collect();
    format!("\nint main(void)\n{{\n{calls}    return 0;\n}}\n")
}

fn printed(ty: Type, place: &str) -> String {
    match ty {
        Type::Bool => format!("printf(\" %d\", {place} ? 1 : 0)"),
        Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => {
            format!("printf(\" %lld\", (long long){place})")
        }
        // So many digits give a number back exactly.
        Type::Real => format!("printf(\" %.9g\", (double){place})"),
        Type::Lreal => format!("printf(\" %.17g\", {place})"),
    }
}

pub(super) fn literal(value: Value, ty: Type) -> String {
    match (value, ty) {
        (Value::Bool(b), _) => b.to_string(),
        (Value::Real(x), _) if x.is_nan() => "NAN".to_owned(),
        (Value::Real(x), _) if x.is_infinite() => (if x < 0.0 { "-INFINITY" } else { "INFINITY" }).to_owned(),
        (Value::Real(x), Type::Real) => format!("{:?}f", x as f32),
        (Value::Real(x), _) => format!("{x:?}"),
        (Value::Int(n) | Value::Time(n), Type::Real | Type::Lreal) => format!("{n}.0"),
        (Value::Int(n) | Value::Time(n), Type::Time) => match n {
            i64::MIN => "INT64_MIN".to_owned(),
            n if n < 0 => format!("-INT64_C({})", n.unsigned_abs()),
            n => format!("INT64_C({n})"),
        },
        (Value::Int(n) | Value::Time(n), Type::Dint) if n == i64::from(i32::MIN) => "INT32_MIN".to_owned(),
        (Value::Int(n) | Value::Time(n), Type::Uint | Type::Udint) => format!("{n}u"),
        (Value::Int(n) | Value::Time(n), _) => n.to_string(),
    }
}
