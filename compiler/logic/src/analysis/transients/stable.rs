//! What stays the same for a whole reaction, and what a condition says of it.
//!
//! Inputs and the time are fixed during a reaction (R9, R13), so every expression over inputs and constants is; a delay
//! of such an expression is as well, because its operand and the time decide on it alone (X5). Equal expressions of
//! that sort get one number. A condition that holds asserts some of them and denies others: these are its *literals*.
//! Two conditions with contradictory literals never hold in one reaction, in whichever micro-steps.
//!
//! A condition may also say that a step has been active since before the reaction: `3s/X5` and `[T5 >= 3s]` need time
//! to pass while step 5 is active, and no time passes within a reaction.

use grafc_model::chart::{
    Arithmetic, Bits, Comparison, ExprId, ExprKind, Mode, StepId, TransitionId, Type, Value, VariableId, VariableKind,
};
use grafc_net::Net;
use index_vec::{IndexVec, define_index_type};
use rustc_hash::FxHashMap;

define_index_type! {
    /// Expressions that have one value in any one reaction.
    pub(super) struct Class = u32;
}

/// Of a longer condition only so many operands are looked at, to stay linear.
const LOOKED_AT: usize = 32;

/// What a condition that holds says of a class.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Literal {
    pub(super) class: Class,
    /// Whether it is true, or else false.
    pub(super) asserted: bool,
}

/// What a condition says.
#[derive(Clone, Default, Debug)]
struct Said {
    literals: Vec<Literal>,
    /// Steps that have been active since before the reaction if the condition holds after its first micro-step.
    waited: Vec<StepId>,
    /// Steps that must be active; for a macro-step or a grafcet any step of it, all being within the same step.
    active: Vec<StepId>,
    /// Inputs in it, in order.
    inputs: Vec<VariableId>,
    never: bool,
}

/// The classes of a net and what its conditions say.
pub(super) struct Stable {
    classes: IndexVec<ExprId, Option<Class>>,
    meaning: IndexVec<Class, Meaning>,
    /// Empty once all have been numbered.
    known: FxHashMap<Meaning, Class>,
    /// What the conditions say, list by list: most say little, and there are many.
    literals: Lists<Literal>,
    waited: Lists<StepId>,
    active: Lists<StepId>,
    inputs: Lists<VariableId>,
    never: IndexVec<TransitionId, bool>,
}

/// A list for each transition, one behind the other.
struct Lists<T> {
    ends: IndexVec<TransitionId, u32>,
    all: Vec<T>,
}

impl<T> Lists<T> {
    fn new(net: &Net) -> Self {
        Lists { ends: IndexVec::with_capacity(net.transitions.len()), all: Vec::new() }
    }

    /// Takes a list, whose room is left for the next one.
    fn push(&mut self, list: &mut Vec<T>) {
        self.all.append(list);
        self.ends.push(self.all.len() as u32);
    }

    fn of(&self, t: TransitionId) -> &[T] {
        let begin = t.index().checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.all[begin as usize..self.ends[t] as usize]
    }
}

/// What a class stands for; equal meanings are one class.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
enum Meaning {
    Value(Type, Bits),
    Input(VariableId),
    Not(Class),
    And(Class, Class),
    Or(Class, Class),
    Xor(Class, Class),
    /// Equality, less or, of reals only, less or equal.
    Compare(Comparison, Class, Class),
    Arithmetic(Arithmetic, Type, Class, Class),
    Negate(Class),
    Widen(Type, Class),
    Delay(i64, Class, i64),
}

impl Stable {
    pub(super) fn new(net: &Net) -> Self {
        let mut stable = Stable {
            classes: IndexVec::with_capacity(net.exprs.len()),
            meaning: IndexVec::new(),
            known: FxHashMap::default(),
            literals: Lists::new(net),
            waited: Lists::new(net),
            active: Lists::new(net),
            inputs: Lists::new(net),
            never: IndexVec::with_capacity(net.transitions.len()),
        };
        for e in net.exprs.indices() {
            let class = stable.class_of(net, e);
            stable.classes.push(class);
        }
        stable.known = FxHashMap::default();
        let mut said = Said::default();
        for transition in &net.transitions {
            stable.read(net, transition.condition, &mut said);
            stable.literals.push(&mut said.literals);
            stable.waited.push(&mut said.waited);
            stable.active.push(&mut said.active);
            stable.inputs.push(&mut said.inputs);
            stable.never.push(std::mem::take(&mut said.never));
        }
        stable
    }

    /// How many classes there are.
    pub(super) fn count(&self) -> usize {
        self.meaning.len()
    }

    /// Whether an expression has one value in any one reaction.
    pub(super) fn is_fixed(&self, e: ExprId) -> bool {
        self.classes[e].is_some()
    }

    /// What the condition of a transition says of classes.
    pub(super) fn literals(&self, t: TransitionId) -> &[Literal] {
        self.literals.of(t)
    }

    /// Whether the condition never holds.
    pub(super) fn never(&self, t: TransitionId) -> bool {
        self.never[t]
    }

    /// Whether the activation of a step before a transition is not enough to let it clear in the next micro-step, even
    /// if nothing has changed in the condition: because the condition asks for time to pass there, or for a step within
    /// that step to be active, which was not active before either.
    pub(super) fn needs_more(&self, net: &Net, t: TransitionId, step: StepId) -> bool {
        let outward = |s: &StepId| std::iter::successors(net.places[*s].encloser(), |e| net.places[*e].encloser());
        self.waited.of(t).contains(&step)
            || self.active.of(t).iter().any(|s| outward(s).take(LOOKED_AT).any(|e| e == step))
    }

    /// Whether two conditions read a common input, as far as was looked: where not, neither says anything of the other.
    pub(super) fn share_inputs(&self, t: TransitionId, u: TransitionId) -> bool {
        let inputs = self.inputs.of(u);
        self.inputs.of(t).iter().any(|v| inputs.binary_search(v).is_ok())
    }

    /// Whether two conditions never hold in one reaction, as their literals show.
    pub(super) fn exclude(&self, t: TransitionId, u: TransitionId) -> bool {
        self.literals(t).iter().any(|a| self.literals(u).iter().any(|b| self.contradict(*a, *b)))
    }

    /// Whether two literals exclude each other.
    pub(super) fn contradict(&self, a: Literal, b: Literal) -> bool {
        if a.class == b.class {
            return a.asserted != b.asserted;
        }
        // `n = 1` and `n = 2`
        let number = |c: Class| matches!(self.meaning[c], Meaning::Value(ty, _) if !is_real(ty));
        match (self.meaning[a.class], self.meaning[b.class]) {
            (Meaning::Compare(Comparison::Equal, a1, a2), Meaning::Compare(Comparison::Equal, b1, b2)) => {
                let constants =
                    |(x, y): (Class, Class)| if number(x) { Some((y, x)) } else { number(y).then_some((x, y)) };
                match (constants((a1, a2)), constants((b1, b2))) {
                    (Some((x, m)), Some((y, n))) => a.asserted && b.asserted && x == y && m != n,
                    (None, _) | (_, None) => false,
                }
            }
            _ => false,
        }
    }

    fn number(&mut self, meaning: Meaning) -> Class {
        if let Some(known) = self.known.get(&meaning) {
            return *known;
        }
        let class = self.meaning.push(meaning);
        self.known.insert(meaning, class);
        class
    }

    fn value(&mut self, ty: Type, value: Value) -> Class {
        self.number(Meaning::Value(ty, Bits::of(value, ty)))
    }

    fn truth(&self, class: Class) -> Option<bool> {
        match self.meaning[class] {
            Meaning::Value(Type::Bool, bits) => Some(bits.value(Type::Bool) == Value::Bool(true)),
            _ => None,
        }
    }

    fn not(&mut self, a: Class) -> Class {
        match (self.truth(a), self.meaning[a]) {
            (Some(b), _) => self.value(Type::Bool, Value::Bool(!b)),
            (None, Meaning::Not(inner)) => inner,
            (None, _) => self.number(Meaning::Not(a)),
        }
    }

    /// The class of an expression whose operands have been numbered.
    fn class_of(&mut self, net: &Net, e: ExprId) -> Option<Class> {
        let expr = &net.exprs[e];
        let class = |stable: &Self, e: ExprId| stable.classes[e];
        let ordered = |a: Class, b: Class| if a <= b { (a, b) } else { (b, a) };
        Some(match expr.kind {
            ExprKind::Literal(value) => self.value(expr.ty, value),
            ExprKind::Variable(v) => {
                let variable = &net.variables[v];
                match (variable.mode, variable.kind) {
                    (Mode::Wire | Mode::Stored, _) => return None,
                    (Mode::Given, VariableKind::Input) => self.number(Meaning::Input(v)),
                    // A constant, or a variable that nothing ever assigns.
                    (Mode::Given, VariableKind::Constant | VariableKind::Internal | VariableKind::Output) => {
                        self.value(variable.ty, variable.initial())
                    }
                }
            }
            ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_) => return None,
            ExprKind::Not(a) => {
                let a = class(self, a)?;
                self.not(a)
            }
            ExprKind::And(a, b) => {
                let (a, b) = ordered(class(self, a)?, class(self, b)?);
                match (self.truth(a), self.truth(b)) {
                    (Some(false), _) | (_, Some(true)) => a,
                    (_, Some(false)) | (Some(true), _) => b,
                    (None, None) if a == b => a,
                    (None, None) => self.number(Meaning::And(a, b)),
                }
            }
            ExprKind::Or(a, b) => {
                let (a, b) = ordered(class(self, a)?, class(self, b)?);
                match (self.truth(a), self.truth(b)) {
                    (Some(true), _) | (_, Some(false)) => a,
                    (_, Some(true)) | (Some(false), _) => b,
                    (None, None) if a == b => a,
                    (None, None) => self.number(Meaning::Or(a, b)),
                }
            }
            ExprKind::Xor(a, b) => {
                let (a, b) = ordered(class(self, a)?, class(self, b)?);
                self.number(Meaning::Xor(a, b))
            }
            ExprKind::Delay { on, operand, off } => {
                let operand = class(self, operand)?;
                self.number(Meaning::Delay(on.ms, operand, off.ms))
            }
            ExprKind::Compare(op, left, right) => {
                let (a, b) = (class(self, left)?, class(self, right)?);
                self.comparison(op, is_real(net.exprs[left].ty), a, b)
            }
            ExprKind::Arithmetic(op, a, b) => {
                let (a, b) = (class(self, a)?, class(self, b)?);
                self.number(Meaning::Arithmetic(op, expr.ty, a, b))
            }
            ExprKind::Negate(a) => {
                let a = class(self, a)?;
                self.number(Meaning::Negate(a))
            }
            ExprKind::Widen(a) => {
                let a = class(self, a)?;
                self.number(Meaning::Widen(expr.ty, a))
            }
        })
    }

    /// Of reals `a < b` may be false and `a >= b` too: one of them may be no number.
    fn comparison(&mut self, op: Comparison, real: bool, a: Class, b: Class) -> Class {
        let (op, a, b, denied) = match op {
            Comparison::Equal => (Comparison::Equal, a.min(b), a.max(b), false),
            Comparison::NotEqual => (Comparison::Equal, a.min(b), a.max(b), true),
            Comparison::Less => (Comparison::Less, a, b, false),
            Comparison::Greater => (Comparison::Less, b, a, false),
            Comparison::LessEqual if real => (Comparison::LessEqual, a, b, false),
            Comparison::GreaterEqual if real => (Comparison::LessEqual, b, a, false),
            Comparison::LessEqual => (Comparison::Less, b, a, true),
            Comparison::GreaterEqual => (Comparison::Less, a, b, true),
        };
        let class = self.number(Meaning::Compare(op, a, b));
        if denied { self.not(class) } else { class }
    }

    /// What a condition says when it holds; nothing has been said yet.
    fn read(&self, net: &Net, condition: ExprId, said: &mut Said) {
        let (mut first, mut open) = (Some(Claim { e: condition, asserted: true, since: false }), Vec::new());
        let mut looked_at = 0;
        while let Some(claim) = first.take().or_else(|| open.pop()).filter(|_| looked_at < LOOKED_AT) {
            looked_at += 1;
            if let Some(class) = self.classes[claim.e] {
                self.literal(class, claim.asserted, said);
            }
            let with = |e, asserted| Claim { e, asserted, since: claim.since };
            match (&net.exprs[claim.e].kind, claim.asserted) {
                (ExprKind::And(a, b), true) | (ExprKind::Or(a, b), false) => {
                    open.extend([with(*b, claim.asserted), with(*a, claim.asserted)]);
                }
                (ExprKind::Not(a), asserted) => open.push(with(*a, !asserted)),
                // An edge is seen in the micro-step after which its operand has the value.
                (ExprKind::Rise(a), true) => open.push(with(*a, true)),
                (ExprKind::Fall(a), true) => open.push(with(*a, false)),
                (ExprKind::Delay { on, operand, off }, true) if off.ms <= 0 => {
                    open.push(Claim { e: *operand, asserted: true, since: claim.since || on.ms > 0 });
                }
                (ExprKind::Delay { on, operand, .. }, false) if on.ms <= 0 => {
                    open.push(with(*operand, false));
                }
                (ExprKind::StepActive(s), true) => {
                    said.active.push(*s);
                    if claim.since {
                        said.waited.push(*s);
                    }
                }
                (ExprKind::MacroActive(m), true) => said.active.push(net.macro_steps[*m].entry),
                (ExprKind::GrafcetActive(g), true) => said.active.extend(net.grafcets[*g].steps.first()),
                (ExprKind::Compare(op, a, b), asserted) => {
                    said.waited.extend(time_has_passed(net, *op, *a, *b, asserted));
                }
                (
                    ExprKind::And(..)
                    | ExprKind::Or(..)
                    | ExprKind::Rise(_)
                    | ExprKind::Fall(_)
                    | ExprKind::Delay { .. }
                    | ExprKind::StepActive(_)
                    | ExprKind::Xor(..)
                    | ExprKind::Literal(_)
                    | ExprKind::Variable(_)
                    | ExprKind::StepTime(_)
                    | ExprKind::MacroActive(_)
                    | ExprKind::GrafcetActive(_)
                    | ExprKind::GrafcetFrozen(_)
                    | ExprKind::Arithmetic(..)
                    | ExprKind::Negate(_)
                    | ExprKind::Widen(_),
                    _,
                ) => {}
            }
        }
        inputs(net, condition, &mut said.inputs);
        said.literals.sort_unstable();
        said.literals.dedup();
        let list = &said.literals;
        said.never |= list.iter().enumerate().any(|(i, a)| list[i + 1..].iter().any(|b| self.contradict(*a, *b)));
    }

    fn literal(&self, class: Class, asserted: bool, said: &mut Said) {
        match (self.truth(class), self.meaning[class]) {
            (Some(truth), _) => said.never |= truth != asserted,
            (None, Meaning::Not(inner)) => said.literals.push(Literal { class: inner, asserted: !asserted }),
            (None, _) => said.literals.push(Literal { class, asserted }),
        }
    }
}

/// An expression with the value that it must have.
#[derive(Clone, Copy)]
struct Claim {
    e: ExprId,
    asserted: bool,
    /// Whether it must have had the value in every micro-step of the reaction so far.
    since: bool,
}

/// The inputs that a condition reads.
fn inputs(net: &Net, condition: ExprId, found: &mut Vec<VariableId>) {
    let (mut first, mut open) = (Some(condition), Vec::new());
    let mut looked_at = 0;
    while let Some(e) = first.take().or_else(|| open.pop()).filter(|_| looked_at < LOOKED_AT) {
        looked_at += 1;
        match net.exprs[e].kind {
            ExprKind::Variable(v) if net.variables[v].kind == VariableKind::Input => found.push(v),
            _ => open.extend(net.exprs[e].kind.operands()),
        }
    }
    found.sort_unstable();
    found.dedup();
}

/// The step whose duration is more than zero if the comparison holds (or, denied, does not).
fn time_has_passed(net: &Net, op: Comparison, a: ExprId, b: ExprId, asserted: bool) -> Option<StepId> {
    use Comparison::{Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};
    let constant = |e: ExprId| match net.exprs[e].kind {
        ExprKind::Literal(Value::Time(ms)) => Some(ms),
        ExprKind::Variable(v) => match (net.variables[v].kind, net.variables[v].initial()) {
            (VariableKind::Constant, Value::Time(ms)) => Some(ms),
            _ => None,
        },
        _ => None,
    };
    let (step, op, ms) = match (&net.exprs[a].kind, &net.exprs[b].kind) {
        (ExprKind::StepTime(s), _) => (*s, op, constant(b)?),
        (_, ExprKind::StepTime(s)) => (*s, op.mirrored(), constant(a)?),
        _ => return None,
    };
    let passed = match (op, asserted) {
        (Greater, true) | (LessEqual, false) => ms >= 0,
        (GreaterEqual | Equal, true) | (Less | NotEqual, false) => ms > 0,
        (Less | LessEqual | NotEqual, true) | (Greater | GreaterEqual | Equal, false) => false,
    };
    passed.then_some(step)
}

fn is_real(ty: Type) -> bool {
    match ty {
        Type::Real | Type::Lreal => true,
        Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => false,
    }
}
