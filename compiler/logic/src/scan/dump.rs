//! The scan program as text, to look at and to compare: [`dump`] is complete, [`equations`] says only what is computed
//! from what.
//!
//! Variables go by the names that the program wishes for them; a further one of the same name gets a number.

use crate::scan::{Choice, Division, Origin, Program, Role, State, Statement, TimerId, Told, VarId, Variable};
use grafc_formula::number::zero;
use grafc_formula::{Formula, FormulaId, Type, Value};
use grafc_model::dump::{comment, list, literal, name, section, type_name, value};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// Shared parts of a formula are written at each use; one that would be longer is only measured.
const LARGEST_FORMULA: u64 = 100_000;

/// The whole program: variables, timers, where each step is held, and all statements.
pub fn dump(program: &Program) -> String {
    let dump = Dump::new(program, Style::Statements);
    let mut out = format!("program {}{}\n", name(&program.name), comment(&program.comment));
    let variables = program.variables.iter_enumerated().map(|(id, variable)| dump.variable(id, variable));
    section(&mut out, "variables", variables);
    section(&mut out, "timers", program.timers.indices().map(|id| dump.timer(id)));
    section(&mut out, "steps", program.steps.iter().map(|step| dump.formula(step.active)));
    section(&mut out, "states", program.states.iter().map(|state| dump.state(state)));
    section(&mut out, "first", dump.lines(&program.first));
    section(&mut out, "before", dump.lines(&program.before));
    section(&mut out, &dump.heading_of_micro_step(), dump.lines(&program.micro_step));
    section(&mut out, "after", dump.lines(&program.after));
    out
}

/// Each equation of the program on a line, under the headings of its sections.
pub fn equations(program: &Program) -> String {
    let dump = Dump::new(program, Style::Equations);
    let mut out = format!("equations of {}\n", name(&program.name));
    section(&mut out, "at the first call", dump.lines(&program.first));
    section(&mut out, "before the evolution", dump.lines(&program.before));
    section(&mut out, "in each micro-step", dump.lines(&program.micro_step));
    section(&mut out, "after the evolution", dump.lines(&program.after));
    out
}

/// How statements are written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Style {
    Statements,
    Equations,
}

struct Dump<'p> {
    program: &'p Program,
    style: Style,
    variables: IndexVec<VarId, String>,
    timers: IndexVec<TimerId, String>,
    /// For each formula, how many parts it has when written out.
    sizes: Vec<u64>,
}

impl<'p> Dump<'p> {
    fn new(program: &'p Program, style: Style) -> Self {
        let mut sizes: Vec<u64> = Vec::with_capacity(program.pool.len());
        for id in program.pool.ids() {
            let below = program.pool.operands(id).map(|operand| sizes[operand.index()]);
            sizes.push(below.fold(1, u64::saturating_add));
        }
        let variables = unique(program.variables.iter().map(|v| v.name.as_str()));
        let timers = unique(program.timers.iter().map(|t| t.name.as_str()));
        Dump { program, style, variables: variables.collect(), timers: timers.collect(), sizes }
    }

    fn variable(&self, id: VarId, variable: &Variable) -> String {
        let role = match variable.role {
            Role::Input => "input",
            Role::Output => "output",
            Role::Internal => "var",
            Role::Constant => "const",
            Role::Step => "step",
            Role::State => "state",
            Role::Flag(_) => "flag",
            Role::Memory => "memory",
            Role::Temporary => "temporary",
            Role::Observed => "observed",
        };
        let address = variable.address.as_ref().map(|address| format!(" at {address:?}")).unwrap_or_default();
        let initial = if variable.initial() == zero(variable.ty) && variable.role != Role::Constant {
            String::new()
        } else {
            format!(" := {}", value(variable.initial()))
        };
        let (name, ty) = (&self.variables[id], type_name(variable.ty));
        let retain = if variable.retain { "retain " } else { "" };
        format!("{retain}{role} {name} : {ty}{initial}{address}{}", comment(&variable.comment))
    }

    fn timer(&self, id: TimerId) -> String {
        let timer = &self.program.timers[id];
        format!("{} : {}{}", self.timers[id], self.preset(id), comment(&timer.comment))
    }

    fn preset(&self, id: TimerId) -> String {
        match self.program.timers[id].preset {
            None => "no preset".to_owned(),
            Some(preset) => match preset.constant {
                Some(constant) => self.variables[constant].clone(),
                None => value(Value::Time(preset.ms)),
            },
        }
    }

    fn state(&self, state: &State) -> String {
        let idle = state.idle.map(|idle| format!("idle {idle}, ")).unwrap_or_default();
        let values = list(state.values.iter().map(|(step, value)| format!("{step} {value}")));
        format!("{}: {idle}{values}", self.variables[state.variable])
    }

    fn heading_of_micro_step(&self) -> String {
        match self.program.repeat {
            None => "micro-step, once".to_owned(),
            Some(repeat) => {
                let again = &self.variables[repeat.again];
                let limit = repeat.limit.map(|limit| {
                    format!(", at most {} times, counted by {}", limit.bound, self.variables[limit.count])
                });
                format!("micro-step, repeated while {again}{}", limit.unwrap_or_default())
            }
        }
    }

    fn lines(&self, statements: &[Statement]) -> Vec<String> {
        let mut lines = Vec::new();
        self.statements(&mut lines, statements, "");
        lines
    }

    /// Recurses as deep as statements are nested, which the encodings bound.
    fn statements(&self, lines: &mut Vec<String>, statements: &[Statement], indent: &str) {
        let deeper = format!("{indent}  ");
        for statement in statements {
            match statement {
                Statement::Heading(heading) => lines.push(format!("{indent}-- {}", self.program.heading(*heading))),
                Statement::Assign { target, value, origin, told } => {
                    let (target, value) = (&self.variables[*target], self.formula(*value));
                    lines.push(match self.style {
                        Style::Statements => format!("{indent}{target} := {value}{}", self.remarked(*origin, *told)),
                        Style::Equations => format!("{indent}{target} = {value}"),
                    });
                }
                Statement::Divide(Division { target, modulo, dividend, divisor, flag, origin: _ }) => {
                    let (target, flag) = (&self.variables[*target], &self.variables[*flag]);
                    let op = if *modulo { "MOD" } else { "/" };
                    let value = format!("{} {op} {}", self.operand(*dividend), self.operand(*divisor));
                    lines.push(match self.style {
                        Style::Statements => format!("{indent}{target} := {value}, or 0 and {flag}"),
                        Style::Equations => format!("{indent}{target} = {value}"),
                    });
                }
                Statement::CallTimer { timer, input, origin: _ } => {
                    let (name, input) = (&self.timers[*timer], self.formula(*input));
                    lines.push(match self.style {
                        Style::Statements => format!("{indent}{name}({input})"),
                        Style::Equations => format!("{indent}{name} = TON({input}, {})", self.preset(*timer)),
                    });
                }
                Statement::Case { of, arms } => {
                    lines.push(match self.style {
                        Style::Statements => format!("{indent}case {}", self.variables[*of]),
                        Style::Equations => format!("{indent}where {} is", self.variables[*of]),
                    });
                    for arm in arms {
                        let remark = match self.style {
                            Style::Statements => self.remarked(arm.origin, arm.told),
                            Style::Equations => String::new(),
                        };
                        lines.push(format!("{deeper}{}:{remark}", arm.value));
                        self.statements(lines, &arm.body, &format!("{deeper}  "));
                    }
                }
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &**choice;
                    let word = if self.style == Style::Statements { "if" } else { "where" };
                    for (place, (when, body)) in branches.iter().enumerate() {
                        let before = if place == 0 { "" } else { "else " };
                        lines.push(format!("{indent}{before}{word} {}", self.formula(*when)));
                        self.statements(lines, body, &deeper);
                    }
                    if !otherwise.is_empty() {
                        lines.push(format!("{indent}else"));
                        self.statements(lines, otherwise, &deeper);
                    }
                }
            }
        }
    }

    fn remarked(&self, origin: Origin, told: Told) -> String {
        self.program.remark(origin, told).map(|text| format!("  -- {}", text.escape_debug())).unwrap_or_default()
    }

    /// An operand of a division.
    fn operand(&self, id: FormulaId) -> String {
        let text = self.formula(id);
        if self.holds_together(id) { text } else { format!("({text})") }
    }

    fn formula(&self, root: FormulaId) -> String {
        if self.sizes[root.index()] > LARGEST_FORMULA {
            return format!("(a formula of {} parts)", self.sizes[root.index()]);
        }
        let pool = &self.program.pool;
        let mut out = String::new();
        let mut open = vec![Piece::Formula(root)];
        while let Some(piece) = open.pop() {
            let id = match piece {
                Piece::Text(text) => {
                    out.push_str(text);
                    continue;
                }
                Piece::Operand(id) if self.holds_together(id) => id,
                Piece::Operand(id) => {
                    out.push('(');
                    open.extend([Piece::Text(")"), Piece::Formula(id)]);
                    continue;
                }
                Piece::Formula(id) => id,
            };
            let infix = |open: &mut Vec<Piece>, word: &'static str| {
                let operands: Vec<FormulaId> = pool.operands(id).collect();
                for (place, operand) in operands.into_iter().enumerate().rev() {
                    open.push(Piece::Operand(operand));
                    if place > 0 {
                        open.extend([Piece::Text(" "), Piece::Text(word), Piece::Text(" ")]);
                    }
                }
            };
            match pool.get(id) {
                Formula::Constant(of) => out.push_str(&self.constant(*of, pool.ty(id))),
                Formula::Variable(v) => out.push_str(&self.variables[*v]),
                Formula::TimerDone(t) => out.push_str(&format!("{}.Q", self.timers[*t])),
                Formula::TimerElapsed(t) => out.push_str(&format!("{}.ET", self.timers[*t])),
                Formula::Not(a) => open.extend([Piece::Operand(*a), Piece::Text("NOT ")]),
                Formula::Negate(a) => open.extend([Piece::Operand(*a), Piece::Text("-")]),
                Formula::And(_) => infix(&mut open, "AND"),
                Formula::Or(_) => infix(&mut open, "OR"),
                Formula::Xor(..) => infix(&mut open, "XOR"),
                Formula::Compare(op, ..) => infix(&mut open, op.sign()),
                Formula::Arithmetic(op, ..) => infix(&mut open, op.sign()),
                Formula::Widen(a) => {
                    out.push_str(type_name(pool.ty(id)));
                    open.extend([Piece::Text(")"), Piece::Formula(*a), Piece::Text("(")]);
                }
            }
        }
        out
    }

    /// A constant; in equations without its type, which what it is compared or computed with has as well.
    fn constant(&self, of: Value, ty: Type) -> String {
        match (of, self.style) {
            (Value::Bool(truth), _) => if truth { "TRUE" } else { "FALSE" }.to_owned(),
            (_, Style::Statements) => literal(of, ty),
            (_, Style::Equations) => value(of),
        }
    }

    /// Whether a formula needs no parentheses as an operand.
    fn holds_together(&self, id: FormulaId) -> bool {
        match self.program.pool.get(id) {
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Not(_)
            | Formula::Widen(_) => true,
            Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_) => false,
        }
    }
}

/// What is still to be written of a formula.
enum Piece {
    Text(&'static str),
    Operand(FormulaId),
    Formula(FormulaId),
}

/// Names, each told from those before it.
fn unique<'n>(names: impl Iterator<Item = &'n str>) -> impl Iterator<Item = String> {
    let mut seen: FxHashMap<&str, u32> = FxHashMap::default();
    names.map(move |wanted| {
        let count = seen.entry(wanted).or_default();
        *count += 1;
        if *count == 1 { name(wanted) } else { format!("{}~{count}", name(wanted)) }
    })
}

#[cfg(test)]
mod tests {
    use super::{dump, equations};
    use crate::scan::by_hand::{self, empty};
    use crate::scan::{
        Arm, Division, Flag, Heading, Held, Origin, Preset, Program, Role, Statement, Step, StepId, Timer, Told, VarId,
    };
    use grafc_diagnostics::Span;
    use grafc_formula::{Arithmetic, Comparison, FormulaId, Type, Value};

    fn variable(program: &mut Program, role: Role, name: &str, ty: Type) -> VarId {
        let id = by_hand::variable(program, role, ty);
        program.variables[id].name = name.into();
        id
    }

    fn assign(target: VarId, value: FormulaId) -> Statement {
        Statement::Assign { target, value, origin: Origin::Step(StepId::new(0)), told: Told::All }
    }

    #[test]
    fn all_statements_in_both_styles() {
        let mut p = empty();
        let a = variable(&mut p, Role::Input, "a", Type::Bool);
        let n = variable(&mut p, Role::Input, "n", Type::Int);
        let (q, wide) =
            (variable(&mut p, Role::Temporary, "q", Type::Int), variable(&mut p, Role::Memory, "w", Type::Dint));
        let again = variable(&mut p, Role::Temporary, "a", Type::Bool);
        let flag = variable(&mut p, Role::Flag(Flag::Div0), "DIV0", Type::Bool);
        let preset = Some(Preset { ms: 1500, constant: None });
        let timer = p.timers.push(Timer { name: "on a".into(), preset, comment: None });
        let pool = &mut p.pool;
        let (a, n_, three) =
            (pool.variable(a, Type::Bool), pool.variable(n, Type::Int), pool.constant(Value::Int(3), Type::Int));
        let (done, above) = (pool.timer_done(timer), pool.compare(Comparison::Greater, n_, three));
        let either = pool.or([a, above]);
        let neither = pool.not(either);
        let all = pool.and([done, neither]);
        let sum = pool.arithmetic(Arithmetic::Add, Type::Int, n_, three);
        let long = pool.widen(Type::Dint, n_);
        let otherwise = vec![assign(again, a)];
        let arm = Arm {
            told: Told::Name,
            origin: Origin::Step(StepId::new(0)),
            ..by_hand::arm(-1, vec![assign(wide, long)])
        };
        let (label, comment) = ("x".into(), Some("why".into()));
        p.steps.push(Step { label, comment, span: Span::default(), held: Held::Bit(again), active: a });
        p.after = vec![
            Statement::Heading(Heading::Outputs),
            by_hand::call(timer, a),
            Statement::choice(vec![(all, vec![assign(q, sum)]), (a, vec![assign(q, n_)])], otherwise),
            Statement::Case { of: n, arms: vec![arm] },
            Statement::Divide(Division {
                target: q,
                modulo: false,
                dividend: n_,
                divisor: n_,
                flag,
                origin: Origin::Chart,
            }),
        ];
        let after = |text: &str| {
            text.lines()
                .skip_while(|line| !line.starts_with("after"))
                .skip(1)
                .map(|l| l[2..].to_owned())
                .collect::<Vec<_>>()
        };
        assert_eq!(
            after(&dump(&p)),
            [
                "-- outputs",
                "`on a`(a)",
                "if `on a`.Q AND NOT (a OR (n > int#3))",
                "  q := n + int#3  -- step x: why",
                "else if a",
                "  q := n  -- step x: why",
                "else",
                "  a~2 := a  -- step x: why",
                "case n",
                "  -1:  -- step x",
                "    w := dint(n)  -- step x: why",
                "q := n / n, or 0 and DIV0",
            ]
        );
        assert_eq!(
            after(&equations(&p)),
            [
                "-- outputs",
                "`on a` = TON(a, 1500ms)",
                "where `on a`.Q AND NOT (a OR (n > 3))",
                "  q = n + 3",
                "else where a",
                "  q = n",
                "else",
                "  a~2 = a",
                "where n is",
                "  -1:",
                "    w = dint(n)",
                "q = n / n",
            ]
        );
    }

    /// Each formula holds the one before it twice.
    #[test]
    fn what_is_shared_too_often_is_only_measured() {
        let mut p = empty();
        let (a, b) = (variable(&mut p, Role::Input, "a", Type::Bool), variable(&mut p, Role::Input, "b", Type::Bool));
        let y = variable(&mut p, Role::Output, "y", Type::Bool);
        let (mut value, b) = (p.pool.variable(a, Type::Bool), p.pool.variable(b, Type::Bool));
        for _ in 0..60 {
            let (both, either) = (p.pool.and([value, b]), p.pool.or([value, b]));
            value = p.pool.xor(both, either);
        }
        p.after = vec![assign(y, value)];
        let text = dump(&p);
        assert!(text.contains("y := (a formula of ") && text.len() < 1000, "{text}");
    }
}
