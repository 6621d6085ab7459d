//! Formulas as contacts in series and side by side.
//!
//! ```text
//! clr_3 OR X1 AND NOT clr_1           part_1 := X1 AND NOT clr_1        ──┤X1├──┤/clr_1├──( part_1 )
//!                                     clr_3 OR part_1                   ──┬─┤clr_3├──┬──(…)
//!                                                                         └─┤part_1├─┘
//! X6 AND (a OR b AND c)                                                 ──┤X6├──┬─┤a├──────┬──(…)
//!                                                                               └─┤b├──┤c├─┘
//! n > 5                               part_2 := GT(n, 5)
//! ```
//!
//! A rung has groups of branches, but no groups within a branch: what is nested deeper is a rung of its own and a
//! variable. Right at the left rail all branches have one contact or all have several, for Beremiz's generator, which
//! sorts the branches, compares no text with a list (Python 3, 2024). It also walks through all ways from the left to
//! the right, so these are few.
//!
//! Recursion is as deep as a formula, which [`crate::limits`] bounds.

use super::rung::{BlockCall, Coil, Contact, End, Item, Rung, Sink, Storage};
use crate::comment::clean;
use crate::iec::declarations::Entry;
use crate::iec::literals;
use crate::iec::names::Names;
use crate::st::Texts;
use ecow::EcoString;
use grafc_formula::{Comparison, Formula, FormulaId, List, TimerId, Type, Value};
use grafc_logic::scan::Program;
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};

/// So many ways through a rung are few.
const MOST_WAYS: usize = 64;

/// Something that must let the power through.
#[derive(Clone)]
pub(super) enum Factor {
    Contact(Contact),
    /// A formula, or its negation.
    Formula(FormulaId, bool),
    /// One of several.
    AnyOf(Vec<(FormulaId, bool)>),
}

/// What a formula looks like. With each operand stands whether it is negated.
enum CircuitForm {
    /// All of them.
    Product(Vec<(FormulaId, bool)>),
    /// One of several.
    Sum(Vec<(FormulaId, bool)>),
    /// Exactly one of two.
    Either((FormulaId, bool), (FormulaId, bool)),
    /// What one contact shows.
    Contact(FormulaId, bool),
}

/// A growing ladder.
pub(super) struct Ladder<'p> {
    pub program: &'p Program,
    pub names: &'p mut Names,
    pub texts: &'p Texts<'p>,
    /// For each timer the variable that its output goes to.
    pub timer_outputs: IndexVec<TimerId, EcoString>,
    /// The timers that are called under conditions.
    pub enabled: FxHashSet<TimerId>,
    pub rungs: Vec<Rung>,
    /// Variables for what has a rung of its own.
    pub parts: Vec<Entry>,
    /// What is to stand above the next rung.
    pub comments: Vec<String>,
    /// The last of what was said.
    pub said: String,
    /// The variables of formulas that got a rung since something was written.
    pub known: FxHashMap<FormulaId, EcoString>,
}

impl Ladder<'_> {
    /// Adds a rung below what is there.
    pub fn rung(&mut self, items: Vec<Item>, end: End) {
        let comments = std::mem::take(&mut self.comments);
        self.rungs.push(Rung { comments, items, end });
    }

    /// Adds a rung with one coil.
    pub fn coil(&mut self, items: Vec<Item>, name: &str, storage: Storage) {
        self.rung(items, End::Coils(vec![Coil { name: name.into(), storage }]));
    }

    /// What lets the power through where all factors do.
    pub fn items(&mut self, factors: Vec<Factor>) -> Vec<Item> {
        let mut items = Vec::new();
        let mut due: Vec<Factor> = factors.into_iter().rev().collect();
        while let Some(factor) = due.pop() {
            let (id, negated) = match factor {
                Factor::Contact(contact) => {
                    items.push(Item::Contact(contact));
                    continue;
                }
                Factor::AnyOf(list) => {
                    items.push(self.group(list));
                    continue;
                }
                Factor::Formula(id, negated) => (id, negated),
            };
            match self.shape(id, negated) {
                CircuitForm::Product(list) => {
                    due.extend(list.into_iter().rev().map(|(id, not)| Factor::Formula(id, not)))
                }
                CircuitForm::Sum(list) => items.push(self.group(list)),
                CircuitForm::Either(a, b) => items.push(Item::Group(self.either(a, b).into())),
                CircuitForm::Contact(id, negated) => items.push(Item::Contact(self.contact(id, negated))),
            }
        }
        self.fit(items)
    }

    /// One of several, nested ones taken in.
    fn group(&mut self, list: Vec<(FormulaId, bool)>) -> Item {
        let mut branches = Vec::new();
        let mut due: Vec<(FormulaId, bool)> = list.into_iter().rev().collect();
        while let Some((id, negated)) = due.pop() {
            match self.shape(id, negated) {
                CircuitForm::Sum(list) => due.extend(list.into_iter().rev()),
                CircuitForm::Either(a, b) => branches.extend(self.either(a, b)),
                CircuitForm::Product(_) | CircuitForm::Contact(..) => branches.push(self.series(id, negated)),
            }
        }
        match branches.len() {
            1 if branches[0].len() == 1 => Item::Contact(branches.remove(0).remove(0)),
            _ => Item::Group(branches),
        }
    }

    /// Exactly one of two.
    fn either(&mut self, a: (FormulaId, bool), b: (FormulaId, bool)) -> [Vec<Contact>; 2] {
        let (a, b) = (self.contact(a.0, a.1), self.contact(b.0, b.1));
        let (a_not, b_not) = (a.inverse(), b.inverse());
        [vec![a, b_not], vec![a_not, b]]
    }

    /// A branch. One that has a group in it gets a rung of its own.
    fn series(&mut self, id: FormulaId, negated: bool) -> Vec<Contact> {
        let mut factors = Vec::new();
        let mut due = vec![(id, negated)];
        while let Some((id, negated)) = due.pop() {
            match self.shape(id, negated) {
                CircuitForm::Product(list) => due.extend(list.into_iter().rev()),
                CircuitForm::Contact(id, negated) => factors.push((id, negated)),
                CircuitForm::Sum(_) | CircuitForm::Either(..) => {
                    factors.clear();
                    break;
                }
            }
        }
        if factors.is_empty() {
            return vec![self.contact(id, negated)];
        }
        factors.into_iter().map(|(id, negated)| self.contact(id, negated)).collect()
    }

    /// What a formula, or its negation, looks like.
    fn shape(&self, id: FormulaId, negated: bool) -> CircuitForm {
        let pool = &self.program.pool;
        let each = |list: List| pool.list(list).iter().map(|id| (*id, negated)).collect();
        match pool.get(id) {
            Formula::Constant(Value::Bool(truth)) if *truth != negated => CircuitForm::Product(Vec::new()),
            Formula::Not(a) => self.shape(*a, !negated),
            Formula::And(list) if negated => CircuitForm::Sum(each(*list)),
            Formula::And(list) => CircuitForm::Product(each(*list)),
            Formula::Or(list) if negated => CircuitForm::Product(each(*list)),
            Formula::Or(list) => CircuitForm::Sum(each(*list)),
            Formula::Xor([a, b]) => CircuitForm::Either((*a, false), (*b, negated)),
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => CircuitForm::Contact(id, negated),
        }
    }

    /// A formula as one contact: of its variable, or of one that a rung of its own writes.
    pub fn contact(&mut self, id: FormulaId, negated: bool) -> Contact {
        let (mut id, mut negated) = (id, negated);
        while let Formula::Not(a) = self.program.pool.get(id) {
            (id, negated) = (*a, !negated);
        }
        let name = match self.leaf(id).or_else(|| self.known.get(&id).cloned()) {
            Some(name) => name,
            None => {
                let name = self.part(id);
                self.known.insert(id, name.clone());
                name
            }
        };
        Contact { name, negated }
    }

    /// The variable that has a formula's value without further ado.
    pub fn leaf(&self, id: FormulaId) -> Option<EcoString> {
        match self.program.pool.get(id) {
            Formula::Variable(variable) => Some(self.names.variables[*variable].clone()),
            Formula::TimerDone(timer) => Some(self.timer_outputs[*timer].clone()),
            Formula::Constant(_)
            | Formula::TimerElapsed(_)
            | Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => None,
        }
    }

    /// A formula at a pin. Beremiz takes what stands before a `#` for a type, so the sign of a constant is behind it.
    pub fn text(&self, id: FormulaId) -> EcoString {
        let pool = &self.program.pool;
        pool.as_constant(id).map_or_else(|| self.texts.of(id).into(), |value| literals::operand(value, pool.ty(id)))
    }

    /// Writes a formula to a new variable.
    fn part(&mut self, id: FormulaId) -> EcoString {
        if let Formula::Compare(op, [a, b]) = self.program.pool.get(id) {
            return self.comparison(*op, [self.text(*a), self.text(*b)]).name;
        }
        let note = Some(self.texts.of(id));
        if self.program.pool.as_truth(id) == Some(false) {
            let name = self.new_part(note);
            self.coil(Vec::new(), &name, Storage::Reset);
            return name;
        }
        let items = self.items(vec![Factor::Formula(id, false)]);
        let name = self.new_part(note);
        self.coil(items, &name, Storage::Plain);
        name
    }

    /// A contact that is closed where a comparison holds, and the rung that compares.
    pub fn comparison(&mut self, op: Comparison, [a, b]: [EcoString; 2]) -> Contact {
        let (kind, sign) = match op {
            Comparison::Equal => ("EQ", "="),
            Comparison::NotEqual => ("NE", "<>"),
            Comparison::Less => ("LT", "<"),
            Comparison::LessEqual => ("LE", "<="),
            Comparison::Greater => ("GT", ">"),
            Comparison::GreaterEqual => ("GE", ">="),
        };
        let name = self.new_part(Some(format!("{a} {sign} {b}")));
        let outputs = vec![("ENO", Sink::Open), ("OUT", Sink::Coil(name.clone()))];
        let inputs = vec![("IN1", a), ("IN2", b)];
        self.rung(Vec::new(), End::Block(BlockCall { kind, instance: None, power: "EN", inputs, outputs }));
        Contact { name, negated: false }
    }

    /// A contact for what has a rung of its own.
    pub fn aside(&mut self, items: Vec<Item>) -> Contact {
        let name = self.new_part(None);
        self.coil(items, &name, Storage::Plain);
        Contact { name, negated: false }
    }

    /// Declares a variable, with what it stands for.
    fn new_part(&mut self, note: Option<String>) -> EcoString {
        let name = self.names.namer.name(&format!("part_{}", self.parts.len() + 1));
        let comment = note.map(|text| clean(&text).into());
        self.parts.push(Entry { comment, ..Entry::plain(name.clone(), Type::Bool) });
        name
    }

    /// What the readers take.
    fn fit(&mut self, mut items: Vec<Item>) -> Vec<Item> {
        if let Some(Item::Group(branches)) = items.first()
            && is_mixed(branches)
        {
            match items.iter().position(|item| matches!(item, Item::Contact(_))) {
                // It makes no difference what comes first.
                Some(place) => items[..=place].rotate_right(1),
                None => {
                    let (single, long): (Vec<_>, Vec<_>) = branches.clone().into_iter().partition(|b| b.len() == 1);
                    let contact = self.aside(one_of(long));
                    items[0] = Item::Group([single, vec![vec![contact]]].concat());
                }
            }
        }
        let mut fitting: Vec<Item> = Vec::with_capacity(items.len());
        let mut ways = 1;
        for item in items {
            if let Item::Group(branches) = &item {
                if ways > 1 && ways * branches.len() > MOST_WAYS {
                    fitting = vec![Item::Contact(self.aside(fitting))];
                    ways = 1;
                }
                ways *= branches.len();
            }
            fitting.push(item);
        }
        fitting
    }
}

/// Whether some branches have one contact and others more.
fn is_mixed(branches: &[Vec<Contact>]) -> bool {
    let single = branches.iter().filter(|branch| branch.len() == 1).count();
    single > 0 && single < branches.len()
}

/// Branches, or the only one.
fn one_of(mut branches: Vec<Vec<Contact>>) -> Vec<Item> {
    match branches.len() {
        1 => branches.remove(0).into_iter().map(Item::Contact).collect(),
        _ => vec![Item::Group(branches)],
    }
}
