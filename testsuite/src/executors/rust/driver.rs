//! The Rust code that plays traces and prints what [`crate::executors::jobs`] reads.

use crate::executors::jobs::{flags, outputs};
use grafc_backends::rust::{Names, size_of};
use grafc_logic::scan::{Flag, Program, Role, VarId};
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::Stimulus;
use std::fmt::Write as _;

/// What stands before all modules: whatever a compiler has to say about generated code is a fault.
pub(super) const HEAD: &str = "#![deny(warnings)]\n";

/// Clocks start here, so that they wrap around within a trace.
const START: u32 = u32::MAX - 1500;

/// So many calls after the last, the chart is saved and restored.
const CALLS_BETWEEN_SAVES: usize = 3;

/// The name of a job's module.
pub(super) fn module(index: usize) -> String {
    format!("job_{index}")
}

/// The function that plays one job.
pub(super) fn write(index: usize, program: &Program, names: &Names, stimuli: &[Stimulus]) -> String {
    let (module, chart) = (module(index), &names.chart);
    let mut out =
        format!("#[allow(clippy::all)]\nfn play_{index}() {{\n    let mut chart = {module}::{chart}::new();\n");
    // What `grafc stats` says of the chart's size.
    let bytes = size_of(program);
    let _ = writeln!(out, "    #[cfg(target_pointer_width = \"64\")]\n    assert_eq!(size_of_val(&chart), {bytes});");
    let inputs: Vec<(VarId, Type)> = program
        .variables
        .iter_enumerated()
        .filter(|(_, variable)| variable.role == Role::Input)
        .map(|(id, variable)| (id, variable.ty))
        .collect();
    let fields = |stimulus: &Stimulus| {
        let values = inputs.iter().zip(&stimulus.inputs);
        values
            .map(|((id, ty), value)| format!("{}: {}", names.variables[*id], literal(*value, *ty)))
            .collect::<Vec<_>>()
    };
    let _ = writeln!(out, "    let calls = [");
    for stimulus in stimuli {
        let now = START.wrapping_add(stimulus.t_ms as u32);
        let _ = writeln!(out, "        ({now}u32, {module}::Inputs {{ {} }}),", fields(stimulus).join(", "));
    }
    let _ = writeln!(out, "    ];\n    for (row, (now, inputs)) in calls.iter().enumerate() {{");
    let _ = writeln!(out, "        let outputs = *chart.scan(inputs, *now);\n        let _ = outputs;");
    let _ = writeln!(out, "        print!(\"{index} {{row}}\");");
    for (id, variable) in outputs(program) {
        let name = &names.variables[id];
        let shown =
            if variable.ty == Type::Bool { format!("u8::from(outputs.{name})") } else { format!("outputs.{name}") };
        let _ = writeln!(out, "        print!(\" {{:?}}\", {shown});");
    }
    let _ = writeln!(
        out,
        "        let situation: Vec<_> = chart.active_steps().collect();
        for step in {module}::Step::ALL {{
            assert_eq!(chart.is_active(step), situation.contains(&step));
            print!(\" {{}}\", u8::from(chart.is_active(step)));
        }}"
    );
    let mut never = vec![Flag::Livelock, Flag::AllocConflict, Flag::ForceConflict, Flag::Div0];
    for (_, flag) in flags(program) {
        never.retain(|other| *other != flag);
        let _ = writeln!(out, "        print!(\" {{}}\", u8::from(chart.flags().{}));", flag_name(flag));
    }
    for flag in never {
        let _ = writeln!(out, "        assert!(!chart.flags().{});", flag_name(flag));
    }
    let _ = writeln!(
        out,
        "        println!();
        if row % {CALLS_BETWEEN_SAVES} == 1 {{
            let again = {module}::{chart}::restore(&chart.save(), *now).expect(\"what was saved\");
            assert_eq!(chart.save(), again.save());
            assert!({module}::{chart}::restore(&chart.save()[1..], *now).is_none());
            chart = again;
        }}
    }}
}}
"
    );
    out
}

fn flag_name(flag: Flag) -> &'static str {
    match flag {
        Flag::Livelock => "livelock",
        Flag::AllocConflict => "alloc_conflict",
        Flag::ForceConflict => "force_conflict",
        Flag::Div0 => "div0",
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
        (Value::Real(x), Type::Real) => format!("{:?}", x as f32),
        (Value::Real(x), _) => format!("{x:?}"),
    }
}
