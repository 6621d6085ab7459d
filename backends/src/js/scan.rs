//! The parts of a scan, a function each, and which steps are active.

use super::expressions::Expressions;
use super::places::Places;
use super::statements::Statements;
use super::text::quoted;
use crate::braces::Braces as _;
use crate::temporaries::{PARTS, parts};
use crate::writer::Writer;
use grafc_formula::{Formula, FormulaId};
use grafc_logic::scan::{Division, Flag, Program, Repeat, Role, Statement, VarId};

/// The groups of what a chart keeps that functions may be given.
const GROUPS: [&str; 8] = ["inputs", "outputs", "variables", "flags", "m", "delays", "seen", "now"];

/// The functions of the parts, with what they do.
const FUNCTIONS: [(&str, &str); PARTS] = [
    ("begin", "what is done once a scan, before its micro-steps"),
    ("microStep", "a micro-step; whether another is needed"),
    ("end", "what is done once a scan, after its micro-steps"),
    ("restoring", "what follows from memory that has been given back"),
];

/// Writes them.
pub(super) fn write(out: &mut Writer, program: &Program, places: &Places, expressions: &Expressions) {
    let statements = Statements { places, expressions };
    for (part, sections) in parts(program).into_iter().enumerate() {
        let (name, about) = FUNCTIONS[part];
        let mut groups = Groups { places, used: [false; GROUPS.len()], seen: vec![false; program.pool.len()] };
        sections.iter().for_each(|section| groups.block(section));
        let limit = program.repeat.and_then(|repeat| repeat.limit);
        match part {
            0 => limit.iter().for_each(|limit| groups.variable(limit.count)),
            1 => {
                program.repeat.iter().for_each(|repeat| groups.variable(repeat.again));
                limit
                    .iter()
                    .for_each(|limit| [limit.count, limit.flag].map(|v| groups.variable(v)).into_iter().collect());
            }
            _ => {}
        }
        out.blank();
        out.comment(about);
        out.open(&head(name, &groups.used));
        let declared: Vec<&str> = places.declared(part).iter().map(|v| places.read(*v).as_str()).collect();
        declare(out, &declared);
        sections.iter().for_each(|section| statements.block(out, section));
        match part {
            0 => limit.iter().for_each(|limit| out.line(&format!("{} = 0;", places.read(limit.count)))),
            1 => again(out, places, program.repeat),
            _ => {}
        }
        out.close("}");
    }
    situation(out, program, expressions);
}

fn head(name: &str, used: &[bool]) -> String {
    let groups: Vec<&str> = GROUPS.into_iter().zip(used).filter_map(|(group, used)| used.then_some(group)).collect();
    if groups.is_empty() {
        return format!("function {name}() {{");
    }
    format!("function {name}({{ {} }}) {{", groups.join(", "))
}

/// Declares local variables, as many on a line as there is room for.
fn declare(out: &mut Writer, names: &[&str]) {
    let mut line = String::new();
    for name in names {
        if line.is_empty() {
            line.push_str("let ");
        } else if out.indent() + line.len() + name.len() + 3 > out.width() {
            out.line(&format!("{line};"));
            line = "let ".to_owned();
        } else {
            line.push_str(", ");
        }
        line.push_str(name);
    }
    if !line.is_empty() {
        out.line(&format!("{line};"));
    }
}

/// The end of a micro-step (R9): whether another is needed; where there is a limit, the flag when it is hit.
fn again(out: &mut Writer, places: &Places, repeat: Option<Repeat>) {
    out.blank();
    let Some(repeat) = repeat else { return out.line("return false;") };
    let again = places.read(repeat.again);
    let Some(limit) = repeat.limit else { return out.line(&format!("return {again};")) };
    let count = places.read(limit.count);
    out.open(&format!("if (!{again}) {{"));
    out.line("return false;");
    out.close("}");
    out.line(&format!("{count} += 1;"));
    out.open(&format!("if ({count} < {}) {{", limit.bound));
    out.line("return true;");
    out.close("}");
    out.line(&format!("flags.{} = true;", Flag::Livelock.name()));
    out.line("return false;");
}

/// The active steps, once a scan has begun.
fn situation(out: &mut Writer, program: &Program, expressions: &Expressions) {
    out.blank();
    out.comment("the labels of the active steps");
    out.open("function situation({ m }) {");
    out.line("const active = [];");
    for step in &program.steps {
        let active = expressions.text(out, step.active);
        out.line(&format!("if ({active}) active.push({});", quoted(&step.label)));
    }
    out.line("return active;");
    out.close("}");
}

/// Which groups statements use.
struct Groups<'p> {
    places: &'p Places<'p>,
    used: [bool; GROUPS.len()],
    seen: Vec<bool>,
}

impl Groups<'_> {
    fn variable(&mut self, v: VarId) {
        let group = match self.places.program.variables[v].role {
            Role::Input => 0,
            Role::Output => 1,
            Role::Internal => 2,
            Role::Flag(_) => 3,
            Role::Step | Role::State | Role::Memory => 4,
            // What goes from part to part lies in the memory.
            Role::Temporary if self.places.is_kept(v) => 4,
            Role::Observed => 6,
            Role::Constant | Role::Temporary => return,
        };
        self.used[group] = true;
    }

    fn formula(&mut self, root: FormulaId) {
        let pool = &self.places.program.pool;
        let mut open = vec![root];
        while let Some(id) = open.pop() {
            if std::mem::replace(&mut self.seen[id.index()], true) {
                continue;
            }
            match pool.get(id) {
                Formula::Variable(v) => self.variable(*v),
                Formula::TimerDone(_) | Formula::TimerElapsed(_) => self.used[5] = true,
                _ => open.extend(pool.operands(id)),
            }
        }
    }

    /// Statements nest no deeper than lowering nests them.
    fn block(&mut self, statements: &[Statement]) {
        for statement in statements {
            match statement {
                Statement::Heading(_) => {}
                Statement::Assign { target, value, .. } => {
                    self.variable(*target);
                    self.formula(*value);
                }
                Statement::Divide(Division { target, dividend, divisor, flag, .. }) => {
                    [*target, *flag].into_iter().for_each(|v| self.variable(v));
                    [*dividend, *divisor].into_iter().for_each(|id| self.formula(id));
                }
                Statement::CallTimer { input, .. } => {
                    [5, 7].into_iter().for_each(|group| self.used[group] = true);
                    self.formula(*input);
                }
                Statement::Case { of, .. } => self.variable(*of),
                Statement::If(choice) => choice.branches.iter().for_each(|(when, _)| self.formula(*when)),
            }
            statement.bodies().for_each(|body| self.block(body));
        }
    }
}
