//! The C code that plays traces, and the reading of what it prints.
//!
//! A line is `job row value…`: outputs, steps and flags in the order of the program. Reals come with as many digits as
//! their type needs to be read back exactly.

use super::Job;
use grafc_logic::scan::{Flag, Program, Role, VarId, Variable};
use grafc_model::chart::{StepId, Type, Value};
use grafc_model::reaction::{Flags, Response, Stimulus};
use index_vec::IndexVec;
use std::fmt::Write as _;

/// What stands before all units.
pub(super) const HEAD: &str = "\
#include <stdio.h>
#include <string.h>
#include \"iec_std_lib.h\"
TIME __CURRENT_TIME;
BOOL __DEBUG;
#include \"POUS.h\"
#include \"POUS.c\"
static TIME ms(long long t) { TIME r; r.tv_sec = t / 1000; r.tv_nsec = (t % 1000) * 1000000; return r; }
static long long in_ms(TIME t) { return (long long)t.tv_sec * 1000 + t.tv_nsec / 1000000; }
";

/// The function that plays one job.
pub(super) fn write(
    index: usize,
    program: &Program,
    names: &IndexVec<VarId, String>,
    block: &str,
    stimuli: &[Stimulus],
) -> String {
    let block = block.to_uppercase();
    let mut out = format!("static void play_{index}(void) {{\n  static {block} d;\n  long row;\n");
    let mut body = String::new();
    let column = |out: &mut String, ctype: &str, name: &str, cells: Vec<String>| {
        let _ = writeln!(out, "  static const {ctype} {name}[] = {{ {} }};", cells.join(", "));
    };
    column(&mut out, "long long", "t", stimuli.iter().map(|s| s.t_ms.to_string() + "LL").collect());
    let inputs = program.variables.iter_enumerated().filter(|(_, v)| v.role == Role::Input);
    for (place, (id, variable)) in inputs.enumerate() {
        let field = names[id].to_uppercase();
        let cells = stimuli.iter().map(|s| literal(s.inputs[place])).collect();
        let (ctype, value) = match variable.ty {
            Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint => ("long long", format!("in_{place}[row]")),
            Type::Real | Type::Lreal => ("double", format!("in_{place}[row]")),
            Type::Time => ("long long", format!("ms(in_{place}[row])")),
        };
        column(&mut out, ctype, &format!("in_{place}"), cells);
        let _ = writeln!(body, "    d.{field}.value = {value};");
    }
    let _ = writeln!(out, "  {block}_init__(&d, 0);");
    let _ = writeln!(out, "  for (row = 0; row < {}; row++) {{", stimuli.len());
    let _ = writeln!(out, "    __CURRENT_TIME = ms(t[row]);");
    out.push_str(&body);
    let _ = writeln!(out, "    {block}_body__(&d);\n    printf(\"{index} %ld\", row);");
    for (id, variable) in published(program) {
        let field = format!("d.{}.value", names[id].to_uppercase());
        let (format, value) = match variable.ty {
            Type::Bool => ("%d", format!("(int)({field} != 0)")),
            Type::Int | Type::Dint | Type::Uint | Type::Udint => ("%lld", format!("(long long){field}")),
            Type::Real => ("%.9g", format!("(double){field}")),
            Type::Lreal => ("%.17g", format!("(double){field}")),
            Type::Time => ("%lld", format!("in_ms({field})")),
        };
        let _ = writeln!(out, "    printf(\" {format}\", {value});");
    }
    out.push_str("    printf(\"\\n\");\n  }\n}\n");
    out
}

/// The end of the C program: plays all jobs of a batch.
pub(super) fn main(batch: &[usize]) -> String {
    let calls: String = batch.iter().map(|index| format!("  play_{index}();\n")).collect();
    format!("int main(void) {{\n{calls}  return 0;\n}}\n")
}

/// What a response is made of, in the order of the program.
fn published(program: &Program) -> impl Iterator<Item = (VarId, &Variable)> {
    program.variables.iter_enumerated().filter(|(_, variable)| match variable.role {
        Role::Output | Role::Step | Role::Flag(_) => true,
        Role::Input | Role::Internal | Role::Constant | Role::Memory | Role::Temporary => false,
    })
}

fn literal(value: Value) -> String {
    match value {
        Value::Bool(b) => u8::from(b).to_string(),
        Value::Int(n) | Value::Time(n) => format!("{n}LL"),
        Value::Real(x) => format!("{x:e}"),
    }
}

/// The responses of one job, from all that was printed.
pub(super) fn read(job: &Job, index: usize, printed: &str) -> Result<Vec<Response>, String> {
    let head = format!("{index} ");
    let mut responses = Vec::new();
    for line in printed.lines().filter(|line| line.starts_with(&head)) {
        let mut words = line.split(' ').skip(2);
        let mut response = Response { outputs: Vec::new(), situation: Vec::new(), flags: Flags::default() };
        let mut step = 0;
        for (_, variable) in published(&job.program) {
            let word = words.next().ok_or_else(|| format!("`{line}` is too short"))?;
            let value = value(variable.ty, word).ok_or_else(|| format!("`{word}` is no {:?}", variable.ty))?;
            match variable.role {
                Role::Output => response.outputs.push(value),
                Role::Step => {
                    if value == Value::Bool(true) {
                        response.situation.push(StepId::from_usize(step));
                    }
                    step += 1;
                }
                Role::Flag(flag) => {
                    let raised = value == Value::Bool(true);
                    match flag {
                        Flag::Livelock => response.flags.livelock = raised,
                        Flag::AllocConflict => response.flags.alloc_conflict = raised,
                        Flag::ForceConflict => response.flags.force_conflict = raised,
                        Flag::Div0 => response.flags.div0 = raised,
                    }
                }
                Role::Input | Role::Internal | Role::Constant | Role::Memory | Role::Temporary => {}
            }
        }
        responses.push(response);
    }
    Ok(responses)
}

fn value(ty: Type, word: &str) -> Option<Value> {
    Some(match ty {
        Type::Bool => Value::Bool(word == "1"),
        Type::Int | Type::Dint | Type::Uint | Type::Udint => Value::Int(word.parse().ok()?),
        // Nine digits give a single back exactly when they are read as one.
        Type::Real => Value::Real(f64::from(word.parse::<f32>().ok()?)),
        Type::Lreal => Value::Real(word.parse().ok()?),
        Type::Time => Value::Time(word.parse().ok()?),
    })
}
