//! The C or C++ code that plays traces with what a compiler made of function blocks, and prints what [`super::jobs`] reads.

use super::function_block::{Activity, FunctionBlock};
use super::jobs::{flags, outputs};
use grafc_logic::scan::{Role, VarId};
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::Stimulus;
use std::fmt::Write as _;

/// How a compiler's code is used. Its head declares `ms`, a time of so many milliseconds, and `in_ms`, the reverse.
pub(crate) struct Runtime {
    /// What stands before all drivers.
    pub head: &'static str,
    /// What declares `d`, an instance of a block, and makes it ready at a time in milliseconds.
    pub instance: fn(&str, i64) -> String,
    /// What a warm restart does to `d`, an instance of a block that keeps the variables of these names.
    pub restart: fn(&str, &[String]) -> String,
    /// What makes `t` milliseconds the time of this call.
    pub clock: &'static str,
    /// What calls `d`, an instance of a block.
    pub call: fn(&str) -> String,
    /// The value of a variable of `d`.
    pub get: fn(&str) -> String,
    /// What gives a variable of `d` a value.
    pub set: fn(&str, &str) -> String,
}

impl Runtime {
    /// The function that plays one job.
    pub fn driver(&self, index: usize, block: &FunctionBlock, stimuli: &[Stimulus]) -> Result<String, String> {
        let program = &block.program;
        let name = block.name.to_uppercase();
        let get = |id: VarId| (self.get)(&block.names[id].to_uppercase());
        let start = stimuli.first().map_or(0, |stimulus| stimulus.t_ms);
        let mut out = format!("static void play_{index}(void) {{\n  {}\n  long row;\n", (self.instance)(&name, start));
        let mut body = String::new();
        let column = |out: &mut String, ctype: &str, name: &str, cells: Vec<String>| {
            let _ = writeln!(out, "  static const {ctype} {name}[] = {{ {} }};", cells.join(", "));
        };
        column(&mut out, "long long", "times", stimuli.iter().map(|s| s.t_ms.to_string() + "LL").collect());
        let inputs = program.variables.iter_enumerated().filter(|(_, v)| v.role == Role::Input);
        for (place, (id, variable)) in inputs.enumerate() {
            let cells = stimuli.iter().map(|s| literal(s.inputs[place])).collect();
            let (ctype, value) = match variable.ty {
                Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint => {
                    ("long long", format!("in_{place}[row]"))
                }
                Type::Real | Type::Lreal => ("double", format!("in_{place}[row]")),
                Type::Time => ("long long", format!("ms(in_{place}[row])")),
            };
            column(&mut out, ctype, &format!("in_{place}"), cells);
            let _ = writeln!(body, "    {}", (self.set)(&block.names[id].to_uppercase(), &value));
        }
        let kept: Vec<String> = block.kept().map(|name| name.to_uppercase()).collect();
        let restart = stimuli.iter().any(|stimulus| stimulus.restart).then(|| (self.restart)(&name, &kept));
        if restart.is_some() {
            let marks = stimuli.iter().map(|stimulus| u8::from(stimulus.restart).to_string()).collect();
            column(&mut out, "char", "restarts", marks);
        }
        let _ = writeln!(out, "  for (row = 0; row < {}; row++) {{", stimuli.len());
        let _ = writeln!(out, "    long long t = times[row];\n    {}", self.clock);
        if let Some(restart) = restart {
            let _ = writeln!(out, "    if (restarts[row]) {{ {restart} }}");
        }
        out.push_str(&body);
        let _ = writeln!(out, "    {}\n    printf(\"{index} %ld\", row);", (self.call)(&name));
        for (id, variable) in outputs(program) {
            let field = get(id);
            let (format, value) = match variable.ty {
                Type::Bool => ("%d", format!("(int)({field} != 0)")),
                Type::Int | Type::Dint | Type::Uint | Type::Udint => ("%lld", format!("(long long){field}")),
                Type::Real => ("%.9g", format!("(double){field}")),
                Type::Lreal => ("%.17g", format!("(double){field}")),
                Type::Time => ("%lld", format!("in_ms({field})")),
            };
            let _ = writeln!(out, "    printf(\" {format}\", {value});");
        }
        for activity in block.activities()? {
            let active = match activity {
                Activity::Bit(id) => format!("{} != 0", get(id)),
                Activity::Value(id, value) => format!("{} == {value}", get(id)),
            };
            let _ = writeln!(out, "    printf(\" %d\", (int)({active}));");
        }
        for (id, _) in flags(program) {
            let _ = writeln!(out, "    printf(\" %d\", (int)({} != 0));", get(id));
        }
        out.push_str("    printf(\"\\n\");\n  }\n}\n");
        Ok(out)
    }

    /// The whole program, of the drivers of a batch.
    pub fn main<'a>(&self, batch: &[usize], drivers: impl Iterator<Item = &'a str>) -> String {
        let mut out = self.head.to_string();
        out.extend(drivers);
        out.push_str("int main(void) {\n");
        out.extend(batch.iter().map(|index| format!("  play_{index}();\n")));
        out.push_str("  return 0;\n}\n");
        out
    }
}

fn literal(value: Value) -> String {
    match value {
        Value::Bool(b) => u8::from(b).to_string(),
        Value::Int(n) | Value::Time(n) => format!("{n}LL"),
        Value::Real(x) if x.is_nan() => "__builtin_nan(\"\")".to_string(),
        Value::Real(x) if x.is_infinite() => format!("{}__builtin_inf()", if x < 0.0 { "-" } else { "" }),
        Value::Real(x) => format!("{x:e}"),
    }
}
