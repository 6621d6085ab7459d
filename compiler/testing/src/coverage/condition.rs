//! A condition and the atoms that it is made of: which values they have had, and which of them have decided it.
//!
//! An atom is what `and`, `or`, `xor` and `not` join: a variable, an edge, a delay, a comparison. The same atom in two
//! places of a condition is one. What never changes is none.

use grafc_model::chart::{Chart, ExprId, ExprKind, Value, below};
use grafc_model::simulate::Simulator;
use rustc_hash::FxHashMap;

/// Of conditions with so many atoms at most, each vector of their values is kept (MC/DC).
pub const MOST_ATOMS: usize = 6;

/// A condition, and what has been seen of it.
#[derive(Clone, Debug)]
pub struct Condition {
    /// Its expression.
    pub root: ExprId,
    /// Its atoms, in order of the text.
    pub atoms: Vec<Atom>,
    /// For each vector of values of the atoms, whether it holds; if there are not too many.
    truth: Option<u64>,
    /// The vectors that were met.
    met: u64,
}

/// An atom, and what has been seen of it.
#[derive(Clone, Debug)]
pub struct Atom {
    /// Its expression, where it stands first.
    pub expr: ExprId,
    /// How often it was false, and how often it was true.
    pub counts: [u64; 2],
}

/// For each atom, the vectors in which it is true.
const TRUE_IN: [u64; MOST_ATOMS] = [
    0xAAAA_AAAA_AAAA_AAAA,
    0xCCCC_CCCC_CCCC_CCCC,
    0xF0F0_F0F0_F0F0_F0F0,
    0xFF00_FF00_FF00_FF00,
    0xFFFF_0000_FFFF_0000,
    0xFFFF_FFFF_0000_0000,
];

impl Condition {
    /// A condition of a chart. `classes` tells which expressions of the chart are the same.
    pub(super) fn new(chart: &Chart, root: ExprId, classes: &Classes) -> Condition {
        let mut atoms: Vec<Atom> = Vec::new();
        let mut place_of: FxHashMap<u32, usize> = FxHashMap::default();
        let mut open = vec![root];
        let mut joints = Vec::new();
        while let Some(id) = open.pop() {
            let kind = &chart.exprs[id].kind;
            joints.push(id);
            if is_joint(kind) {
                open.extend(kind.operands().rev());
            } else if chart.constant(kind).is_none() {
                place_of.entry(classes.of[id.index()]).or_insert_with(|| {
                    atoms.push(Atom { expr: id, counts: [0; 2] });
                    atoms.len() - 1
                });
            }
        }
        let truth = (atoms.len() <= MOST_ATOMS).then(|| {
            // Operands come before what they are operands of.
            joints.sort_unstable();
            let mut table: FxHashMap<ExprId, u64> = FxHashMap::default();
            for &id in &joints {
                let of = |operand: ExprId| table.get(&operand).copied().unwrap_or_default();
                let value = match chart.exprs[id].kind {
                    ExprKind::Not(a) => !of(a),
                    ExprKind::And(a, b) => of(a) & of(b),
                    ExprKind::Or(a, b) => of(a) | of(b),
                    ExprKind::Xor(a, b) => of(a) ^ of(b),
                    ref kind => match (chart.constant(kind), place_of.get(&classes.of[id.index()])) {
                        (None, Some(place)) => TRUE_IN[*place],
                        (Some(Value::Bool(true)), _) => !0,
                        (Some(_) | None, _) => 0,
                    },
                };
                table.insert(id, value);
            }
            table.get(&root).copied().unwrap_or_default()
        });
        Condition { root, atoms, truth, met: 0 }
    }

    /// The condition was asked in the latest context.
    pub(super) fn ask(&mut self, simulator: &Simulator) {
        let mut vector = 0;
        for (place, atom) in self.atoms.iter_mut().enumerate() {
            let is_true = simulator.holds(atom.expr);
            atom.counts[usize::from(is_true)] += 1;
            if place < MOST_ATOMS {
                vector |= usize::from(is_true) << place;
            }
        }
        if self.truth.is_some() {
            self.met |= 1 << vector;
        }
    }

    /// Adds what was seen of it elsewhere.
    pub(super) fn add(&mut self, other: &Condition) {
        self.met |= other.met;
        for (mine, theirs) in self.atoms.iter_mut().zip(&other.atoms) {
            mine.counts.iter_mut().zip(theirs.counts).for_each(|(mine, theirs)| *mine += theirs);
        }
    }

    /// Whether each atom has decided the condition both ways (masking MC/DC): in two vectors that were met it had different
    /// values, the condition turned out differently, and in each of them it would have turned out otherwise had this atom
    /// alone been another. Nothing is said of an atom that cannot decide it, or where there are too many atoms.
    pub fn decided(&self) -> Vec<Option<bool>> {
        let Some(truth) = self.truth else { return vec![None; self.atoms.len()] };
        let decided = |place: usize| {
            let (is_true, by) = (TRUE_IN[place], 1 << place);
            let flipped = (truth & is_true) >> by | (truth & !is_true) << by;
            let deciding = truth ^ flipped;
            let has = |vectors: u64| self.met & deciding & vectors != 0;
            let both = |of: u64| has(of & is_true) && has(!of & !is_true);
            // Beyond the vectors that there are, the table repeats itself.
            (deciding != 0).then(|| both(truth) || both(!truth))
        };
        (0..self.atoms.len()).map(decided).collect()
    }
}

fn is_joint(kind: &ExprKind) -> bool {
    match kind {
        ExprKind::Not(_) | ExprKind::And(..) | ExprKind::Or(..) | ExprKind::Xor(..) => true,
        ExprKind::Literal(_)
        | ExprKind::Variable(_)
        | ExprKind::StepActive(_)
        | ExprKind::StepTime(_)
        | ExprKind::MacroActive(_)
        | ExprKind::GrafcetActive(_)
        | ExprKind::GrafcetFrozen(_)
        | ExprKind::Rise(_)
        | ExprKind::Fall(_)
        | ExprKind::Delay { .. }
        | ExprKind::Compare(..)
        | ExprKind::Arithmetic(..)
        | ExprKind::Negate(_)
        | ExprKind::Widen(_) => false,
    }
}

/// Which expressions of a chart say the same: they have the same class.
pub(super) struct Classes {
    of: Vec<u32>,
}

impl Classes {
    pub(super) fn new(chart: &Chart) -> Classes {
        let mut known: FxHashMap<String, u32> = FxHashMap::default();
        let mut of: Vec<u32> = Vec::with_capacity(chart.exprs.len());
        for expr in &chart.exprs {
            let below = expr.kind.operands().map(|operand| of[operand.index()]).collect::<Vec<_>>();
            let what = match expr.kind {
                ExprKind::Literal(value) => format!("{value:?}"),
                ExprKind::Variable(id) => format!("{id:?}"),
                ExprKind::StepActive(id) => format!("X{id:?}"),
                ExprKind::StepTime(id) => format!("T{id:?}"),
                ExprKind::MacroActive(id) => format!("M{id:?}"),
                ExprKind::GrafcetActive(id) => format!("G{id:?}"),
                ExprKind::GrafcetFrozen(id) => format!("F{id:?}"),
                ExprKind::Delay { on, off, .. } => format!("delay {} {}", on.ms, off.ms),
                ExprKind::Compare(op, ..) => format!("{op:?}"),
                ExprKind::Arithmetic(op, ..) => format!("{op:?}"),
                ExprKind::Not(_) => "not".to_string(),
                ExprKind::And(..) => "and".to_string(),
                ExprKind::Or(..) => "or".to_string(),
                ExprKind::Xor(..) => "xor".to_string(),
                ExprKind::Rise(_) => "rise".to_string(),
                ExprKind::Fall(_) => "fall".to_string(),
                ExprKind::Negate(_) => "minus".to_string(),
                ExprKind::Widen(_) => format!("as {:?}", expr.ty),
            };
            let next = known.len() as u32;
            of.push(*known.entry(format!("{what} {below:?}")).or_insert(next));
        }
        Classes { of }
    }
}

/// The place of an atom in the text: all that belongs to it.
pub(super) fn place(chart: &Chart, atom: ExprId) -> grafc_diagnostics::Span {
    below(&chart.exprs, atom).map(|id| chart.exprs[id].span).fold(chart.exprs[atom].span, |all, span| all.to(span))
}
