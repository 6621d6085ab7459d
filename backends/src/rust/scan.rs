//! The statements of one scan.

use super::expressions::{Expressions, SMALL, WIDTH};
use super::literals::{type_name, zero};
use super::locals::{Locals, ROOT};
use super::names::Names;
use super::places::Places;
use crate::comment::clean;
use crate::writer::Writer;
use grafc_logic::formula::{Formula, FormulaId, Type};
use grafc_logic::scan::{Arm, Flag, Program, Repeat, Role, Statement, TimerId, VarId};
use std::cell::Cell;

/// What a scan uses of what is there: a parameter that it does not use has another name.
#[derive(Clone, Copy, Default)]
pub(super) struct Used {
    pub inputs: bool,
    pub now: bool,
    pub steps: bool,
    pub division: bool,
    pub remainder: bool,
}

/// Writes the statements of one scan, and says what they use.
pub(super) fn write(
    out: &mut Writer,
    program: &Program,
    names: &Names,
    places: &Places,
    expressions: &Expressions,
) -> Used {
    let locals = Locals::new(program);
    let body = Body { program, names, places, expressions, locals, used: Cell::default(), blocks: Cell::new(ROOT) };
    let mut place = body.sequence(out, ROOT, 0, &program.first);
    place = body.sequence(out, ROOT, place, &program.before);
    match program.repeat {
        None => place = body.sequence(out, ROOT, place, &program.micro_step),
        Some(repeat) => {
            body.repeat(out, place, repeat);
            place += 1;
        }
    }
    body.sequence(out, ROOT, place, &program.after);
    let mut used = body.used.get();
    used.inputs |= reads_input(program);
    used
}

/// Whether a statement reads an input.
fn reads_input(program: &Program) -> bool {
    let pool = &program.pool;
    let mut roots = Vec::new();
    for section in [&program.first, &program.before, &program.micro_step, &program.after] {
        collect(section, &mut roots);
    }
    let mut seen = vec![false; pool.len()];
    while let Some(id) = roots.pop() {
        if std::mem::replace(&mut seen[id.index()], true) {
            continue;
        }
        if matches!(pool.get(id), Formula::Variable(v) if program.variables[*v].role == Role::Input) {
            return true;
        }
        roots.extend(pool.operands(id));
    }
    false
}

/// All formulas of statements.
fn collect(statements: &[Statement], roots: &mut Vec<FormulaId>) {
    for statement in statements {
        match statement {
            Statement::Heading(_) => {}
            Statement::Assign { value, .. } => roots.push(*value),
            Statement::Divide { dividend, divisor, .. } => roots.extend([*dividend, *divisor]),
            Statement::CallTimer { input, .. } => roots.push(*input),
            Statement::Case { of: _, arms } => arms.iter().for_each(|arm| collect(&arm.body, roots)),
            Statement::If { branches, otherwise } => {
                for (when, body) in branches {
                    roots.push(*when);
                    collect(body, roots);
                }
                collect(otherwise, roots);
            }
        }
    }
}

struct Body<'p> {
    program: &'p Program,
    names: &'p Names,
    places: &'p Places<'p>,
    expressions: &'p Expressions<'p>,
    locals: Locals,
    used: Cell<Used>,
    /// The number of the last block, as [`Locals`] counts them.
    blocks: Cell<usize>,
}

impl Body<'_> {
    fn uses(&self, note: impl FnOnce(&mut Used)) {
        let mut used = self.used.get();
        note(&mut used);
        self.used.set(used);
    }

    /// The stability loop (R9); where it has a limit, the flag when it was cut off.
    fn repeat(&self, out: &mut Writer, place: usize, repeat: Repeat) {
        let again = &self.names.variables[repeat.again];
        let limit = repeat.limit.map(|limit| (&self.names.variables[limit.count], limit.bound));
        out.blank();
        self.declare(out, ROOT, place);
        out.open("loop {");
        let inside = self.block();
        if let Some((count, _)) = limit {
            out.line(&format!("{count} += 1;"));
        }
        let end = self.sequence(out, inside, 0, &self.program.micro_step);
        out.blank();
        self.declare(out, inside, end);
        out.open(&format!("if !{again} {{"));
        out.line("break;");
        out.close("}");
        if let Some((count, bound)) = limit {
            out.open(&format!("if {count} >= {bound} {{"));
            let flags = self.program.variables.iter_enumerated();
            for (flag, _) in flags.filter(|(_, v)| v.role == Role::Flag(Flag::Livelock)) {
                out.line(&format!("{} = true;", self.places.read(flag)));
            }
            out.line("break;");
            out.close("}");
        }
        out.close("}");
        out.blank();
    }

    fn block(&self) -> usize {
        self.blocks.set(self.blocks.get() + 1);
        self.blocks.get()
    }

    /// Declares variables that no assignment declares.
    fn declare(&self, out: &mut Writer, block: usize, place: usize) {
        for declared in self.locals.before(block, place) {
            let v = declared.variable;
            let name = &self.names.variables[v];
            let ty = self.program.variables[v].ty;
            if declared.later {
                out.line(&format!("let mut {name};"));
                continue;
            }
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

    /// Statements from a place of a block on; returns the place after them.
    fn sequence(&self, out: &mut Writer, block: usize, start: usize, statements: &[Statement]) -> usize {
        for (offset, statement) in statements.iter().enumerate() {
            let place = start + offset;
            self.declare(out, block, place);
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
                    self.divide(out, declares, *target, *modulo, *dividend, *divisor, *flag);
                }
                Statement::CallTimer { timer, input } => self.call_timer(out, *timer, *input),
                Statement::Case { of, arms } => self.case(out, *of, arms),
                Statement::If { branches, otherwise } => self.branch(out, branches, otherwise),
            }
        }
        start + statements.len()
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
            self.uses(|used| used.steps = true);
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
        a: FormulaId,
        b: FormulaId,
        flag: VarId,
    ) {
        self.uses(|used| if modulo { used.remainder = true } else { used.division = true });
        let pool = &self.program.pool;
        let ty = self.program.variables[target].ty;
        let function = if modulo { "remainder" } else { "divide" };
        let operand = |id: FormulaId| {
            let mut text = Writer::new(&crate::writer::RUST);
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
        self.uses(|used| used.now = true);
        let timer = self.places.timer(timer);
        let width = self.expressions.width(input) + ", now".len();
        let chain = timer.len() + ".call()".len() + width;
        if width <= SMALL && chain <= SMALL.max(timer.len() + 1) && out.indent() + chain < WIDTH {
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
    fn case(&self, out: &mut Writer, of: VarId, arms: &[Arm]) {
        let remark = |arm: &Arm| arm.remark.as_deref().map(clean).unwrap_or_default();
        let label = |arm: &Arm| self.places.variant(of, arm.value).unwrap_or_else(|| arm.value.to_string());
        if let [arm] = arms {
            out.comment(&remark(arm));
            out.open(&format!("if {} == {} {{", self.places.read(of), label(arm)));
            let inside = self.block();
            self.sequence(out, inside, 0, &arm.body);
            return out.close("}");
        }
        out.open(&format!("match {} {{", self.places.read(of)));
        for arm in arms {
            out.comment(&remark(arm));
            out.open(&format!("{} => {{", label(arm)));
            let inside = self.block();
            self.sequence(out, inside, 0, &arm.body);
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
            let inside = self.block();
            self.sequence(out, inside, 0, body);
            out.leave();
            head = "} else if";
        }
        let inside = self.block();
        if branches.is_empty() {
            self.sequence(out, inside, 0, otherwise);
            return;
        }
        if !crate::limits::is_empty(otherwise) {
            out.open("} else {");
            self.sequence(out, inside, 0, otherwise);
            out.leave();
        }
        out.line("}");
    }
}

/// The sign of `a = a op b` where whole numbers need no method to wrap around.
fn compound(op: grafc_logic::formula::Arithmetic, ty: Type) -> Option<&'static str> {
    use grafc_logic::formula::Arithmetic::{Add, Divide, Modulo, Multiply, Subtract};
    let real = matches!(ty, Type::Real | Type::Lreal);
    match op {
        Add if real => Some("+="),
        Subtract if real => Some("-="),
        Multiply if real => Some("*="),
        Divide => Some("/="),
        Modulo => Some("%="),
        Add | Subtract | Multiply => None,
    }
}
