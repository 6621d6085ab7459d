//! The functions of one scan, with what they are given and the tables that find them.

mod statements;

use super::code::{Choice, Code, Needs};
use super::expressions::Expressions;
use super::interface::fields;
use super::literals::{literal, type_name, zero};
use super::locals::{Locals, ROOT};
use super::names::RustNames;
use super::places::Places;
use super::split::{About, Split, Table};
use super::steps::list;
use crate::comment::clean;
use crate::writer::Writer;
use ecow::{EcoString, eco_format};
use grafc_formula::{Type, Value};
use grafc_logic::scan::{Origin, Program, VarId};
use std::cell::Cell;
use std::iter;

/// Writes the scan, and the functions that a large one is parted into.
pub(super) fn write(out: &mut Writer, program: &Program, names: &RustNames, places: &Places, split: &Split) {
    let expressions = Expressions::new(program, places);
    for (index, function) in split.functions.iter().enumerate() {
        let body = RustStatements {
            program,
            names,
            places,
            expressions: &expressions,
            split,
            locals: Locals::new(program, &function.code, &split.shared),
            blocks: Cell::new(ROOT),
        };
        if let Some(table) = function.table.filter(|table| split.tables[*table].first == index) {
            body.table(out, table);
        }
        out.blank();
        if index == 0 {
            body.scan(out, &function.code, function.needs);
        } else {
            let about = match function.about {
                Some(About::Words(words)) => Some(words.to_owned()),
                Some(About::Origin(origin, told)) => program.remark(origin, told),
                None => None,
            };
            let outer = out.origin(match function.about {
                Some(About::Origin(origin, _)) => origin,
                Some(About::Words(_)) | None => Origin::Chart,
            });
            out.comment(&about.map(|text| clean(&text)).unwrap_or_default());
            if split.restore_outputs == Some(index) {
                body.restore_outputs(out, &function.code, function.needs);
                out.origin(outer);
                continue;
            }
            // Else the functions would be put together again.
            if !split.only_finds(index) {
                out.line("#[inline(never)]");
            }
            let Needs { inputs, now, values, .. } = function.needs;
            let parameters: String = split
                .given(index)
                .of([("inputs", INPUTS, inputs), ("now", NOW, now), ("values", VALUES, values)])
                .map(|(name, ty, needed)| format!(", {}: {ty}", if needed { name } else { "_" }))
                .collect();
            let gives = if split.micro_step == Some(index) { " -> bool" } else { "" };
            out.open(&format!("fn {}(&mut self{parameters}){gives} {{", split.name(index)));
            body.function(out, &function.code, function.needs);
            out.close("}");
            out.origin(outer);
        }
    }
}

/// Writes the struct of the values that functions share.
pub(super) fn values(out: &mut Writer, program: &Program, names: &RustNames, places: &Places, shared: &[VarId]) {
    if shared.is_empty() {
        return;
    }
    out.blank();
    out.line("/// Values within one scan.");
    out.open("struct Values {");
    for v in shared {
        let ty = places.state(*v).map_or(type_name(program.variables[*v].ty), |state| &state.ty);
        out.line(&format!("{}: {ty},", names.variables[*v]));
    }
    out.close("}");
}

// The types of what functions are given.
const INPUTS: &str = "&Inputs";
const NOW: &str = "u32";
const VALUES: &str = "&mut Values";

struct RustStatements<'p> {
    program: &'p Program,
    names: &'p RustNames,
    places: &'p Places<'p>,
    expressions: &'p Expressions<'p>,
    split: &'p Split<'p>,
    locals: Locals,
    /// The number of the last block, as [`Locals`] counts them.
    blocks: Cell<usize>,
}

impl RustStatements<'_> {
    fn scan(&self, out: &mut Writer, code: &[Code], needs: Needs) {
        out.line("/// One scan: from the inputs to the outputs.");
        out.line("///");
        out.line("/// `now` is the time in milliseconds of a clock that may start anywhere and wraps around after");
        out.line("/// `u32::MAX`. There must be a scan at least every 24 days: a difference of more than half the");
        out.line("/// range is a clock that was put back, and counts as no time.");
        let parameter = |name: &str, needed: bool| if needed { name.to_owned() } else { format!("_{name}") };
        let (inputs, now) = (parameter("inputs", needs.inputs), parameter("now", needs.now));
        out.open(&format!("pub fn scan(&mut self, {inputs}: &Inputs, {now}: u32) -> &Outputs {{"));
        self.values(out, needs);
        self.function(out, code, needs);
        out.blank();
        out.line("&self.outputs");
        out.close("}");
    }

    fn restore_outputs(&self, out: &mut Writer, code: &[Code], needs: Needs) {
        let inputs = if needs.inputs { format!(", inputs: {INPUTS}") } else { String::new() };
        out.open(&format!("fn restore_outputs(&mut self{inputs}) {{"));
        self.values(out, needs);
        self.function(out, code, needs);
        out.close("}");
    }

    /// The values that functions share, where the first of them begins.
    fn values(&self, out: &mut Writer, needs: Needs) {
        if !needs.values {
            return;
        }
        let zero = |v: &VarId| {
            let ty = self.program.variables[*v].ty;
            let first = |state: &super::names::StateNames| eco_format!("{}::{}", state.ty, state.variants[0].1);
            (self.names.variables[*v].clone(), self.places.state(*v).map_or(zero(ty).into(), first))
        };
        let values: Vec<(EcoString, EcoString)> = self.split.shared.iter().map(zero).collect();
        fields(out, "let values = &mut Values", &values, ";");
    }

    fn function(&self, out: &mut Writer, code: &[Code], needs: Needs) {
        if needs.steps {
            out.line("use Step::*;");
            out.blank();
        }
        self.code(out, ROOT, code);
    }

    fn code(&self, out: &mut Writer, block: usize, code: &[Code]) {
        for (place, code) in code.iter().enumerate() {
            self.declare(out, block, place);
            match code {
                Code::Plain(statement) => self.statement(out, block, place, statement),
                Code::Loop(micro_step) => self.repeat(out, *micro_step),
                Code::Again(again) => {
                    out.blank();
                    out.line(&self.places.read(*again));
                }
                Code::Call(function) => out.line(&format!("{};", self.call(*function))),
                Code::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
                    let mut head = "if";
                    for (condition, body) in branches {
                        let outer = out.inner_origin(origin_of(body));
                        self.expressions.condition(out, head, *condition);
                        out.enter();
                        self.code(out, self.block(), body);
                        out.leave();
                        out.origin(outer);
                        head = "} else if";
                    }
                    let inside = self.block();
                    if !otherwise.is_empty() {
                        out.open("} else {");
                        self.code(out, inside, otherwise);
                        out.leave();
                    }
                    out.line("}");
                }
                Code::Arms(of, arms) => {
                    let inside = |out: &mut Writer, place: usize| self.code(out, self.block(), &arms[place].1);
                    self.arms(out, *of, &arms.iter().map(|(arm, _)| *arm).collect::<Vec<_>>(), inside);
                }
                Code::Table(of, table) => {
                    let arguments = arguments(self.split.tables[*table].needs);
                    let arguments: String = arguments.into_iter().map(|word| format!(", {word}")).collect();
                    let place = self.places.read(*of);
                    out.line(&format!("Self::{}[{place} as usize](self{arguments});", table_name(*table)));
                }
            }
        }
    }

    /// The functions that a table has, by the values of its state.
    fn table(&self, out: &mut Writer, table: usize) {
        let Table { arms, needs, .. } = &self.split.tables[table];
        let types: Vec<&str> = iter::once("&mut Self").chain(needs.of([INPUTS, NOW, VALUES])).collect();
        let nothing = format!("|{}| {{}}", vec!["_"; types.len()].join(", "));
        out.blank();
        out.comment("what is done at each value");
        let head = format!("const {}: &[fn({}); {}] =", table_name(table), types.join(", "), arms.len());
        let function =
            |arm: &Option<usize>| arm.map_or(nothing.clone(), |arm| format!("Self::{}", self.split.name(arm)));
        list(out, &head, "&[", &arms.iter().map(function).collect::<Vec<_>>());
    }

    fn call(&self, function: usize) -> String {
        let arguments = arguments(self.split.functions[function].needs);
        format!("self.{}({})", self.split.name(function), arguments.join(", "))
    }

    /// The stability loop (R9); where it has a limit, the flag when it was cut off.
    fn repeat(&self, out: &mut Writer, micro_step: usize) {
        let Some(repeat) = self.program.repeat else { return };
        out.blank();
        let again = format!("while {}", self.call(micro_step));
        match repeat.limit {
            None => out.line(&format!("{again} {{}}")),
            Some(limit) => {
                let count = self.places.read(limit.count);
                let bound = literal(Value::Int(limit.bound.into()), Type::Dint);
                out.open(&format!("{again} {{"));
                out.line(&format!("{count} += 1;"));
                out.open(&format!("if {count} >= {bound} {{"));
                out.line(&format!("{} = true;", self.places.read(limit.flag)));
                out.line("break;");
                out.close("}");
                out.close("}");
            }
        }
        out.blank();
    }

    fn block(&self) -> usize {
        self.blocks.set(self.blocks.get() + 1);
        self.blocks.get()
    }

    /// Declares variables that no assignment declares.
    fn declare(&self, out: &mut Writer, block: usize, place: usize) {
        for v in self.locals.before(block, place).iter().copied() {
            let name = &self.names.variables[v];
            let ty = self.program.variables[v].ty;
            match self.places.state(v) {
                // It gets a value before it is read.
                Some(state) => {
                    let first = state.variants.first().map_or("", |(_, name)| name);
                    out.line(&format!("let mut {name} = {}::{first};", state.ty));
                }
                None if ty == Type::Bool => out.line(&format!("let mut {name} = false;")),
                None => out.line(&format!("let mut {name}: {} = {};", type_name(ty), zero(ty))),
            }
        }
    }
}

/// Where a branch comes from, whose statements may be elsewhere.
fn origin_of(body: &[Code]) -> Origin {
    match body.first() {
        Some(Code::Plain(statement)) => statement.origin(),
        Some(Code::Loop(_) | Code::Again(_) | Code::Call(_) | Code::If(..) | Code::Arms(..) | Code::Table(..))
        | None => Origin::Chart,
    }
}

/// What a function is given beside the chart.
fn arguments(needs: Needs) -> Vec<&'static str> {
    needs.of(["inputs", "now", "values"]).collect()
}

fn table_name(table: usize) -> String {
    format!("ARMS_{}", table + 1)
}
