//! The statements of one scan.

use super::expressions::{Expressions, SMALL, WIDTH};
use super::interface::fields;
use super::literals::{literal, type_name, zero};
use super::locals::{Locals, ROOT};
use super::names::Names;
use super::parts::{Code, Needs, Parts, Table};
use super::places::Places;
use crate::comment::clean;
use crate::writer::Writer;
use grafc_logic::formula::{Arithmetic, Formula, FormulaId, Type, Value};
use grafc_logic::scan::{Arm, Flag, Program, Role, Statement, TimerId, VarId};
use std::cell::Cell;

/// Writes the scan, and the functions that a large one is parted into.
pub(super) fn write(out: &mut Writer, program: &Program, names: &Names, places: &Places, parts: &Parts) {
    let expressions = Expressions::new(program, places);
    for (index, function) in parts.functions.iter().enumerate() {
        let body = Body {
            program,
            names,
            places,
            expressions: &expressions,
            parts,
            locals: Locals::new(program, &function.code, &parts.shared),
            blocks: Cell::new(ROOT),
        };
        if let Some(table) = function.table.filter(|table| parts.tables[*table].first == index) {
            body.table(out, table);
        }
        out.blank();
        if index == 0 {
            body.scan(out, &function.code, function.needs);
        } else {
            out.comment(&function.about.map(clean).unwrap_or_default());
            // Else the functions would be put together again.
            if !parts.only_finds(index) {
                out.line("#[inline(never)]");
            }
            let parameter = |given: bool, needed: bool, name: &str, ty: &str| {
                let name = if needed { name } else { "_" };
                if given { format!(", {name}: {ty}") } else { String::new() }
            };
            let (given, needs) = (parts.given(index), function.needs);
            let parameters = [
                parameter(given.inputs, needs.inputs, "inputs", INPUTS),
                parameter(given.now, needs.now, "now", NOW),
                parameter(given.values, needs.values, "values", VALUES),
            ]
            .concat();
            let gives = if parts.micro_step == Some(index) { " -> bool" } else { "" };
            out.open(&format!("fn {}(&mut self{parameters}){gives} {{", parts.name(index)));
            body.function(out, &function.code, function.needs);
            out.close("}");
        }
    }
}

/// Writes the struct of the values that functions share.
pub(super) fn values(out: &mut Writer, program: &Program, names: &Names, places: &Places, shared: &[VarId]) {
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

struct Body<'p> {
    program: &'p Program,
    names: &'p Names,
    places: &'p Places<'p>,
    expressions: &'p Expressions<'p>,
    parts: &'p Parts<'p>,
    locals: Locals,
    /// The number of the last block, as [`Locals`] counts them.
    blocks: Cell<usize>,
}

impl Body<'_> {
    fn scan(&self, out: &mut Writer, code: &[Code], needs: Needs) {
        out.line("/// One scan: from the inputs to the outputs.");
        out.line("///");
        out.line("/// `now` is the time in milliseconds of a clock that never goes back. It may start anywhere");
        out.line("/// and wraps around after `u32::MAX`; there must be a scan at least every 49 days.");
        let parameter = |name: &str, needed: bool| if needed { name.to_owned() } else { format!("_{name}") };
        let (inputs, now) = (parameter("inputs", needs.inputs), parameter("now", needs.now));
        out.open(&format!("pub fn scan(&mut self, {inputs}: &Inputs, {now}: u32) -> &Outputs {{"));
        if needs.values {
            let zero = |v: &VarId| {
                let ty = self.program.variables[*v].ty;
                let first = |state: &super::names::StateNames| format!("{}::{}", state.ty, state.variants[0].1);
                (self.names.variables[*v].clone(), self.places.state(*v).map_or(zero(ty).to_owned(), first))
            };
            let values: Vec<(String, String)> = self.parts.shared.iter().map(zero).collect();
            fields(out, "let values = &mut Values", &values, ";");
        }
        self.function(out, code, needs);
        out.blank();
        out.line("&self.outputs");
        out.close("}");
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
                    out.line(self.places.read(*again));
                }
                Code::Call(function) => out.line(&format!("{};", self.call(*function))),
                Code::If(branches, otherwise) => {
                    let mut head = "if";
                    for (condition, body) in branches {
                        self.expressions.condition(out, head, *condition);
                        out.enter();
                        self.code(out, self.block(), body);
                        out.leave();
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
                    let arguments = arguments(self.parts.tables[*table].needs);
                    let arguments: String = arguments.into_iter().map(|word| format!(", {word}")).collect();
                    let place = self.places.read(*of);
                    out.line(&format!("Self::{}[{place} as usize](self{arguments});", table_name(*table)));
                }
            }
        }
    }

    /// The functions that a table has, by the values of its state.
    fn table(&self, out: &mut Writer, table: usize) {
        let Table { arms, needs, .. } = &self.parts.tables[table];
        let types = [
            Some("&mut Self"),
            needs.inputs.then_some(INPUTS),
            needs.now.then_some(NOW),
            needs.values.then_some(VALUES),
        ];
        let types: Vec<&str> = types.into_iter().flatten().collect();
        let nothing = format!("|{}| {{}}", vec!["_"; types.len()].join(", "));
        out.blank();
        out.comment("what is done at each value");
        out.open(&format!("const {}: &[fn({}); {}] = &[", table_name(table), types.join(", "), arms.len()));
        for arm in arms {
            let function = arm.map_or_else(|| nothing.clone(), |arm| format!("Self::{}", self.parts.name(arm)));
            out.line(&format!("{function},"));
        }
        out.close("];");
    }

    fn call(&self, function: usize) -> String {
        let arguments = arguments(self.parts.functions[function].needs);
        format!("self.{}({})", self.parts.name(function), arguments.join(", "))
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
                for (flag, v) in self.program.variables.iter_enumerated() {
                    if v.role == Role::Flag(Flag::Livelock) {
                        out.line(&format!("{} = true;", self.places.read(flag)));
                    }
                }
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

    /// A block of statements, in a block of the text.
    fn statements(&self, out: &mut Writer, statements: &[Statement]) {
        let inside = self.block();
        for (place, statement) in statements.iter().enumerate() {
            self.declare(out, inside, place);
            self.statement(out, inside, place, statement);
        }
    }

    fn statement(&self, out: &mut Writer, block: usize, place: usize, statement: &Statement) {
        match statement {
            Statement::Heading(text) => {
                out.blank();
                out.comment(&clean(text));
            }
            Statement::Assign { target, value, remark } => {
                out.comment(&remark.as_deref().map(clean).unwrap_or_default());
                let declares = self.locals.with(block, place, *target);
                self.assign(out, declares, *target, *value);
            }
            Statement::Divide { target, modulo, dividend, divisor, flag } => {
                let declares = self.locals.with(block, place, *target);
                self.divide(out, declares, *target, *modulo, [*dividend, *divisor], *flag);
            }
            Statement::CallTimer { timer, input } => self.call_timer(out, *timer, *input),
            Statement::Case { of, arms } => {
                let inside = |out: &mut Writer, place: usize| self.statements(out, &arms[place].body);
                self.arms(out, *of, &arms.iter().collect::<Vec<_>>(), inside);
            }
            Statement::If { branches, otherwise } => self.branch(out, branches, otherwise),
        }
    }

    /// The left side of an assignment, with its `let`.
    fn target(&self, declares: Option<bool>, target: VarId, typed: bool) -> String {
        let name = self.places.read(target);
        let Some(written_again) = declares else { return name.to_owned() };
        let name = if self.locals.is_unread(target) { "_" } else { name };
        let mutable = if written_again { "mut " } else { "" };
        let ty = self.program.variables[target].ty;
        let annotation = if typed { format!(": {}", type_name(ty)) } else { String::new() };
        format!("let {mutable}{name}{annotation}")
    }

    fn assign(&self, out: &mut Writer, declares: Option<bool>, target: VarId, value: FormulaId) {
        let pool = &self.program.pool;
        if let Some(step) = self.places.packed(target) {
            let step = &self.names.steps[step];
            let width = step.len() + 2 + self.expressions.width(value);
            if width <= SMALL && out.indent() + "self.set();".len() + width <= WIDTH {
                out.start();
                out.text(&format!("self.set({step}, "));
                self.expressions.flat(out, value);
                out.text(");");
                out.end();
            } else {
                self.expressions.statement(out, "let active", value);
                out.line(&format!("self.set({step}, active);"));
            }
            return;
        }
        if let Some(constant) = pool.as_constant(value) {
            let ty = pool.ty(value);
            let typed = self.places.state(target).is_none() && ty != Type::Bool;
            let value = self.places.value(target, constant, ty);
            return out.line(&format!("{} = {value};", self.target(declares, target, typed)));
        }
        // `a = a + b` has a form of its own.
        if let Formula::Arithmetic(op, a, b) = pool.get(value)
            && declares.is_none()
            && *pool.get(*a) == Formula::Variable(target)
            && let Some(sign) = compound(*op, pool.ty(value))
        {
            out.start();
            out.text(&format!("{} {sign} ", self.places.read(target)));
            self.expressions.flat(out, *b);
            out.text(";");
            return out.end();
        }
        self.expressions.statement(out, &self.target(declares, target, false), value);
    }

    fn divide(
        &self,
        out: &mut Writer,
        declares: Option<bool>,
        target: VarId,
        modulo: bool,
        [a, b]: [FormulaId; 2],
        flag: VarId,
    ) {
        let pool = &self.program.pool;
        let ty = self.program.variables[target].ty;
        let function = if modulo { "remainder" } else { "divide" };
        let operand = |id: FormulaId| {
            let mut text = out.apart();
            self.expressions.flat(&mut text, id);
            let text = text.finish();
            match pool.as_constant(id) {
                None if ty == Type::Time && pool.ty(id) != Type::Time => format!("i64::from({text})"),
                _ => text,
            }
        };
        let flag = format!("&mut {}", self.places.read(flag));
        let arguments = [operand(a), operand(b), flag];
        let head = format!("{} = {function}(", self.target(declares, target, true));
        let flat = arguments.join(", ");
        if flat.len() <= SMALL && out.indent() + head.len() + flat.len() + 2 <= WIDTH {
            return out.line(&format!("{head}{flat});"));
        }
        out.open(&head);
        for argument in arguments {
            out.line(&format!("{argument},"));
        }
        out.close(");");
    }

    fn call_timer(&self, out: &mut Writer, timer: TimerId, input: FormulaId) {
        let timer = self.places.timer(timer);
        let width = self.expressions.width(input) + ", now".len();
        let chain = timer.len() + ".call()".len() + width;
        if chain <= SMALL.max(timer.len() + 1) && out.indent() + chain < WIDTH {
            out.start();
            out.text(&format!("{timer}.call("));
            self.expressions.flat(out, input);
            out.text(", now);");
            return out.end();
        }
        self.expressions.statement(out, "let input", input);
        out.line(&format!("{timer}.call(input, now);"));
    }

    /// An arm a value, under what the value stands for; a single arm is an `if`.
    fn arms(&self, out: &mut Writer, of: VarId, arms: &[&Arm], inside: impl Fn(&mut Writer, usize)) {
        let remark = |arm: &Arm| arm.remark.as_deref().map(clean).unwrap_or_default();
        let label = |arm: &Arm| self.places.variant(of, arm.value).unwrap_or_else(|| arm.value.to_string());
        if let [arm] = arms {
            out.comment(&remark(arm));
            out.open(&format!("if {} == {} {{", self.places.read(of), label(arm)));
            inside(out, 0);
            return out.close("}");
        }
        out.open(&format!("match {} {{", self.places.read(of)));
        for (place, arm) in arms.iter().enumerate() {
            out.comment(&remark(arm));
            out.open(&format!("{} => {{", label(arm)));
            inside(out, place);
            out.close("}");
        }
        if self.places.state(of).is_none_or(|state| state.variants.len() > arms.len()) {
            out.line("_ => {}");
        }
        out.close("}");
    }

    fn branch(&self, out: &mut Writer, branches: &[(FormulaId, Vec<Statement>)], otherwise: &[Statement]) {
        let mut head = "if";
        for (condition, body) in branches {
            self.expressions.condition(out, head, *condition);
            out.enter();
            self.statements(out, body);
            out.leave();
            head = "} else if";
        }
        if crate::limits::is_empty(otherwise) {
            self.block();
        } else {
            out.open("} else {");
            self.statements(out, otherwise);
            out.leave();
        }
        out.line("}");
    }
}

/// What a function is given beside the chart.
fn arguments(needs: Needs) -> Vec<&'static str> {
    let arguments = [needs.inputs.then_some("inputs"), needs.now.then_some("now"), needs.values.then_some("values")];
    arguments.into_iter().flatten().collect()
}

fn table_name(table: usize) -> String {
    format!("ARMS_{}", table + 1)
}

/// The sign of `a = a op b` where whole numbers need no method to wrap around.
fn compound(op: Arithmetic, ty: Type) -> Option<&'static str> {
    let real = matches!(ty, Type::Real | Type::Lreal);
    match op {
        Arithmetic::Add if real => Some("+="),
        Arithmetic::Subtract if real => Some("-="),
        Arithmetic::Multiply if real => Some("*="),
        Arithmetic::Divide => Some("/="),
        Arithmetic::Modulo => Some("%="),
        Arithmetic::Add | Arithmetic::Subtract | Arithmetic::Multiply => None,
    }
}
