//! The C code that plays traces and prints what [`crate::jobs`] reads.

use crate::jobs::{flags, outputs};
use grafc_logic::formula::{Comparison, Formula, FormulaId};
use grafc_logic::scan::{Program, Role, VarId};
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::Stimulus;
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

/// The function that plays one job; an error if a step is held in a way that is not known here.
pub(super) fn write(
    index: usize,
    program: &Program,
    names: &IndexVec<VarId, String>,
    block: &str,
    stimuli: &[Stimulus],
) -> Result<String, String> {
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
    for (id, variable) in outputs(program) {
        let field = field(names, id);
        let (format, value) = match variable.ty {
            Type::Bool => ("%d", format!("(int)({field} != 0)")),
            Type::Int | Type::Dint | Type::Uint | Type::Udint => ("%lld", format!("(long long){field}")),
            Type::Real => ("%.9g", format!("(double){field}")),
            Type::Lreal => ("%.17g", format!("(double){field}")),
            Type::Time => ("%lld", format!("in_ms({field})")),
        };
        let _ = writeln!(out, "    printf(\" {format}\", {value});");
    }
    for active in program.steps.iter().map(|step| step.active) {
        let _ = writeln!(out, "    printf(\" %d\", (int)({}));", is_active(program, names, active)?);
    }
    for (id, _) in flags(program) {
        let _ = writeln!(out, "    printf(\" %d\", (int)({} != 0));", field(names, id));
    }
    out.push_str("    printf(\"\\n\");\n  }\n}\n");
    Ok(out)
}

/// A variable of the instance.
fn field(names: &IndexVec<VarId, String>, id: VarId) -> String {
    format!("d.{}.value", names[id].to_uppercase())
}

/// Whether a step is active: a variable of its own, or the value of the one that holds several.
fn is_active(program: &Program, names: &IndexVec<VarId, String>, id: FormulaId) -> Result<String, String> {
    let pool = &program.pool;
    match pool.get(id) {
        Formula::Variable(v) => Ok(format!("{} != 0", field(names, *v))),
        Formula::Compare(Comparison::Equal, a, b) => match (pool.get(*a), pool.get(*b)) {
            (Formula::Variable(v), Formula::Constant(Value::Int(n))) => Ok(format!("{} == {n}", field(names, *v))),
            (a, b) => Err(format!("a step is active where {a:?} = {b:?}, which nothing here can read")),
        },
        other => Err(format!("a step is active where {other:?} is true, which nothing here can read")),
    }
}

/// The end of the C program: plays all jobs of a batch.
pub(super) fn main(batch: &[usize]) -> String {
    let calls: String = batch.iter().map(|index| format!("  play_{index}();\n")).collect();
    format!("int main(void) {{\n{calls}  return 0;\n}}\n")
}

fn literal(value: Value) -> String {
    match value {
        Value::Bool(b) => u8::from(b).to_string(),
        Value::Int(n) | Value::Time(n) => format!("{n}LL"),
        Value::Real(x) => format!("{x:e}"),
    }
}
