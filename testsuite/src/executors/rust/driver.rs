//! The Rust code that plays traces and prints what [`crate::executors::jobs`] reads.

use crate::executors::jobs::{flag_name, flags, outputs};
use grafc_backends::rust::{RustNames, size_of};
use grafc_logic::scan::{Flag, Program, Role};
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::Stimulus;
use std::fmt::Write as _;

/// What stands before all modules: whatever a compiler has to say about generated code is a fault. What each driver needs
/// is written once, since rustc takes longer for a format or a vector of a type of its own than for a chart.
pub(super) const HEAD: &str = "\
#![deny(warnings)]

/// Prints what came out of a call.
#[allow(dead_code)]
mod shown {
    pub fn truth(value: bool) {
        print!(\"{}\", if value { \" 1\" } else { \" 0\" });
    }
    pub fn number(value: impl Into<i64>) {
        print!(\" {}\", value.into());
    }
    pub fn single(value: f32) {
        print!(\" {value:?}\");
    }
    pub fn double(value: f64) {
        print!(\" {value:?}\");
    }
    pub fn head(job: usize, row: usize) {
        print!(\"{job} {row}\");
    }
    pub fn end() {
        println!();
    }
}

/// The truth of a row, of truths that are the digits of numbers.
#[allow(dead_code)]
fn truth(digits: &[u64], row: usize) -> bool {
    digits[row / 64] >> (row % 64) & 1 == 1
}
";

/// Clocks start here, so that they wrap around within a trace.
const START: u32 = u32::MAX - 1500;

/// So many calls after the last, the chart is saved and restored.
const CALLS_BETWEEN_SAVES: usize = 3;

/// The name of a job's module.
pub(super) fn module(index: usize) -> String {
    format!("job_{index}")
}

/// The function that plays one job.
pub(super) fn write(index: usize, program: &Program, names: &RustNames, stimuli: &[Stimulus]) -> String {
    let (module, chart) = (module(index), &names.chart);
    let mut out = format!(
        "#[allow(clippy::all, unused_mut)]\nfn play_{index}() {{\n    let mut chart = {module}::{chart}::new();\n"
    );
    // What `grafc stats` says of the chart's size.
    let bytes = size_of(program);
    let _ = writeln!(out, "    #[cfg(target_pointer_width = \"64\")]\n    assert!(size_of_val(&chart) == {bytes});");
    let _ = writeln!(out, "    let mut inputs = {module}::Inputs::default();");
    let _ = writeln!(out, "    for row in 0..{} {{", stimuli.len());
    let times = stimuli.iter().map(|stimulus| START.wrapping_add(stimulus.t_ms as u32));
    let _ = writeln!(out, "        let now: u32 = {};", column(times.map(|now| now.to_string())));
    if stimuli.iter().any(|stimulus| stimulus.restart) {
        let restarts = truths(stimuli.iter().map(|stimulus| Value::Bool(stimulus.restart)));
        let again = if program.variables.iter().any(|variable| variable.retain) {
            format!("{module}::{chart}::restarted(&chart.save_retained()).expect(\"what was saved\")")
        } else {
            format!("{module}::{chart}::new()")
        };
        let _ = writeln!(out, "        if {restarts} {{\n            chart = {again};\n        }}");
    }
    let inputs = program.variables.iter_enumerated().filter(|(_, variable)| variable.role == Role::Input);
    for (place, (id, variable)) in inputs.enumerate() {
        let values = stimuli.iter().map(|stimulus| stimulus.inputs[place]);
        let value = match variable.ty {
            Type::Bool => truths(values),
            ty => column(values.map(|value| literal(value, ty))),
        };
        let _ = writeln!(out, "        inputs.{} = {value};", names.variables[id]);
    }
    let _ = writeln!(out, "        let outputs = *chart.scan(&inputs, now);\n        let _ = outputs;");
    let _ = writeln!(out, "        shown::head({index}, row);");
    for (id, variable) in outputs(program) {
        let _ = writeln!(out, "        shown::{}(outputs.{});", shown(variable.ty), names.variables[id]);
    }
    let _ = writeln!(
        out,
        "        let mut situation = chart.active_steps();
        let mut next = situation.next();
        for step in {module}::Step::ALL {{
            let is_listed = next == Some(step);
            assert!(chart.is_active(step) == is_listed);
            shown::truth(is_listed);
            if is_listed {{
                next = situation.next();
            }}
        }}
        assert!(next.is_none());
        drop(situation);"
    );
    let mut never = vec![Flag::Livelock, Flag::AllocConflict, Flag::ForceConflict, Flag::Div0];
    for (_, flag) in flags(program) {
        never.retain(|other| *other != flag);
        let _ = writeln!(out, "        shown::truth(chart.flags().{});", flag_name(flag));
    }
    for flag in never {
        let _ = writeln!(out, "        assert!(!chart.flags().{});", flag_name(flag));
    }
    let _ = writeln!(out, "        shown::end();");
    if program.restoring.is_some() {
        // Outputs are those of the situation, not what was saved of them; a text, since nan is no other than itself.
        let _ = writeln!(
            out,
            "        if row % {CALLS_BETWEEN_SAVES} == 1 {{
            let again = {module}::{chart}::restore(&chart.save(), &inputs, now).expect(\"what was saved\");
            assert!(chart.save() == again.save());
            assert!(format!(\"{{:?}}\", chart.outputs()) == format!(\"{{:?}}\", again.outputs()));
            assert!({module}::{chart}::restore(&chart.save()[1..], &inputs, now).is_none());
            chart = again;
        }}"
        );
    }
    let _ = writeln!(out, "    }}\n}}");
    out
}

/// The value of a row, of one for each.
fn column(values: impl Iterator<Item = String>) -> String {
    format!("[{}][row]", values.collect::<Vec<_>>().join(", "))
}

/// The truth of a row, of one for each.
fn truths(values: impl Iterator<Item = Value>) -> String {
    let mut digits = vec![0_u64];
    for (row, value) in values.enumerate() {
        digits.resize(row / 64 + 1, 0);
        digits[row / 64] |= u64::from(value == Value::Bool(true)) << (row % 64);
    }
    format!("truth(&{digits:?}, row)")
}

/// What prints a value of a type.
fn shown(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "truth",
        Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => "number",
        Type::Real => "single",
        Type::Lreal => "double",
    }
}

/// The end of the program: plays all jobs of a batch.
pub(super) fn main(batch: &[usize]) -> String {
    let calls: String = batch.iter().map(|index| format!("    play_{index}();\n")).collect();
    format!("fn main() {{\n{calls}}}\n")
}

fn literal(value: Value, ty: Type) -> String {
    match (value, ty) {
        (Value::Bool(b), _) => b.to_string(),
        (Value::Int(n), Type::Real | Type::Lreal) => format!("{n}.0"),
        (Value::Int(n) | Value::Time(n), _) => n.to_string(),
        (Value::Real(x), ty) if !x.is_finite() => {
            let (ty, name) =
                (if ty == Type::Real { "f32" } else { "f64" }, if x.is_nan() { "NAN" } else { "INFINITY" });
            format!("{}{ty}::{name}", if x < 0.0 { "-" } else { "" })
        }
        (Value::Real(x), Type::Real) => format!("{:?}", x as f32),
        (Value::Real(x), _) => format!("{x:?}"),
    }
}
