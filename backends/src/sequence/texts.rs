//! What stands in the boxes: names, conditions, actions.

use crate::comment::clean;
use crate::st;
use ecow::{EcoString, eco_format};
use grafc_formula::FormulaId;
use grafc_logic::scan::{Role, VarId};
use grafc_logic::sequence::{Assignment, During, Sequence, When};
use rustc_hash::{FxHashMap, FxHashSet};

/// How the activity of a step is read elsewhere.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Activity {
    /// By the variable that marks it: not every tool lets a step be named before it is declared.
    Marked,
    /// By the step itself, since all steps are declared first.
    Named,
}

/// All texts of a chart.
pub(crate) struct Texts {
    /// The names of the steps, in order.
    pub steps: Vec<EcoString>,
    /// The comment on each step, clean; empty if there is none.
    pub comments: Vec<String>,
    /// The conditions of the transitions, in order.
    pub conditions: Vec<String>,
    /// What each step does.
    pub actions: Vec<Vec<Action>>,
    /// What steps bring along, which is declared nowhere.
    of_steps: FxHashSet<EcoString>,
}

/// A row of an action block.
pub(crate) struct Action {
    pub qualifier: Qualifier,
    pub content: Content,
}

/// How an action is done (IEC 61131-3, 2.6.4.4).
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Qualifier {
    N,
    S,
    R,
    P1,
    P0,
    /// From a time on, and for a time.
    D(String),
    L(String),
}

impl Qualifier {
    /// Its letters.
    pub fn name(&self) -> &'static str {
        match self {
            Qualifier::N => "N",
            Qualifier::S => "S",
            Qualifier::R => "R",
            Qualifier::P1 => "P1",
            Qualifier::P0 => "P0",
            Qualifier::D(_) => "D",
            Qualifier::L(_) => "L",
        }
    }

    /// Its time, if it has one.
    pub fn time(&self) -> Option<&str> {
        match self {
            Qualifier::D(time) | Qualifier::L(time) => Some(time),
            Qualifier::N | Qualifier::S | Qualifier::R | Qualifier::P1 | Qualifier::P0 => None,
        }
    }
}

pub(crate) enum Content {
    /// A variable that the qualifier sets.
    Variable(EcoString),
    /// A value that a continuous action computes, also once when the step is left.
    Computed(Statement),
    /// What is stored.
    Stored(Statement),
}

/// A statement, or several.
#[derive(Clone, Default)]
pub(crate) struct Statement {
    /// On one line.
    pub flat: String,
    /// On as many as it should have.
    pub lines: Vec<String>,
}

impl Content {
    /// The statement, if it is one.
    pub fn statement(&self) -> Option<&Statement> {
        match self {
            Content::Variable(_) => None,
            Content::Computed(statement) | Content::Stored(statement) => Some(statement),
        }
    }

    /// What is read in the row.
    pub fn text(&self) -> &str {
        match self {
            Content::Variable(text) => text,
            Content::Computed(statement) | Content::Stored(statement) => &statement.flat,
        }
    }
}

impl Statement {
    /// Adds another.
    fn add(&mut self, other: Statement) {
        if !self.flat.is_empty() {
            self.flat.push(' ');
        }
        self.flat.push_str(&other.flat);
        self.lines.extend(other.lines);
    }
}

impl Texts {
    /// Spells a chart.
    pub fn new(sequence: &Sequence, activity: Activity) -> Self {
        let names = st::names(&sequence.program);
        let mut spelt: FxHashMap<VarId, EcoString> = FxHashMap::default();
        let mut of_steps = FxHashSet::default();
        for step in &sequence.steps {
            let name = &names[step.active];
            spelt.insert(step.active, eco_format!("{name}.X"));
            spelt.insert(step.duration, eco_format!("{name}.T"));
            of_steps.extend([name.clone(), names[step.duration].clone()]);
            if let Some(marker) = step.marker
                && activity == Activity::Named
            {
                spelt.insert(marker, eco_format!("{name}.X"));
                if !sequence.shown.contains(&marker) {
                    of_steps.insert(names[marker].clone());
                }
            }
        }
        let conditions = sequence.transitions.iter().map(|transition| transition.condition);
        let of_steps_formulas = sequence.steps.iter().flat_map(|step| {
            let holds = step.holds.iter().filter_map(|hold| formula(hold.during));
            let cases = step.stored.iter().flat_map(|assignment| &assignment.cases);
            holds.chain(cases.flat_map(|(guard, value)| guard.iter().copied().chain([*value])))
        });
        let formulas: Vec<FormulaId> = conditions.chain(of_steps_formulas).collect();
        let mut texts = st::spell(&sequence.program, &spelt, &formulas).into_iter();
        let mut next = || texts.next().unwrap_or_default();
        let conditions = sequence.transitions.iter().map(|_| next()).collect();

        let mut actions = Vec::new();
        for step in &sequence.steps {
            let mut rows = Vec::new();
            let mut add = |qualifier, content| rows.push(Action { qualifier, content });
            if let Some(marker) = step.marker.filter(|marker| !of_steps.contains(&names[*marker])) {
                add(Qualifier::N, Content::Variable(names[marker].clone()));
            }
            for hold in &step.holds {
                let name = &names[hold.target];
                let variable = Content::Variable(name.clone());
                match hold.during {
                    During::Step => add(Qualifier::N, variable),
                    During::From(_) => add(Qualifier::D(next()), variable),
                    During::For(_) => add(Qualifier::L(next()), variable),
                    // While the step is active, and once more when it is left: the value is that of the whole chart.
                    During::Value(_) => {
                        let flat = format!("{name} := {};", next());
                        let statement = Statement { lines: vec![flat.clone()], flat };
                        add(Qualifier::N, Content::Computed(statement.clone()));
                        add(Qualifier::P0, Content::Computed(statement));
                    }
                }
            }
            for (variable, set) in &step.latches {
                let qualifier = if *set { Qualifier::S } else { Qualifier::R };
                add(qualifier, Content::Variable(names[*variable].clone()));
            }
            // What is stored at one moment is one action: its statements are in an order that counts.
            let mut moments: [(Qualifier, Statement); 3] =
                [Qualifier::P1, Qualifier::P0, Qualifier::N].map(|qualifier| (qualifier, Statement::default()));
            for assignment in &step.stored {
                let place = match assignment.when {
                    When::Activation => 0,
                    When::Deactivation => 1,
                    When::EachScan => 2,
                };
                moments[place].1.add(statement(&names[assignment.target], assignment, &mut next));
            }
            for (qualifier, statement) in moments.into_iter().filter(|(_, statement)| !statement.lines.is_empty()) {
                add(qualifier, Content::Stored(statement));
            }
            actions.push(rows);
        }
        let steps = sequence.steps.iter().map(|step| names[step.active].clone()).collect();
        let comments = sequence.steps.iter().map(|step| clean(step.comment.as_deref().unwrap_or_default())).collect();
        debug_assert!(sequence.steps.iter().all(|step| sequence.program.variables[step.active].role == Role::Step));
        Texts { steps, comments, conditions, actions, of_steps }
    }

    /// Whether a variable is the activity or the duration of a step.
    pub fn is_of_a_step(&self, name: &str) -> bool {
        self.of_steps.contains(name)
    }
}

fn formula(during: During) -> Option<FormulaId> {
    match during {
        During::Step => None,
        During::From(formula) | During::For(formula) | During::Value(formula) => Some(formula),
    }
}

/// An assignment as a statement.
fn statement(target: &str, assignment: &Assignment, next: &mut impl FnMut() -> String) -> Statement {
    let mut lines = Vec::new();
    for (place, (guard, _)) in assignment.cases.iter().enumerate() {
        match (guard, place) {
            (Some(_), 0) => lines.push(format!("IF {} THEN", next())),
            (Some(_), _) => lines.push(format!("ELSIF {} THEN", next())),
            (None, 0) => {}
            (None, _) => lines.push("ELSE".to_owned()),
        }
        lines.push(format!("{target} := {};", next()));
    }
    if lines.len() > 1 {
        lines.push("END_IF;".to_owned());
    }
    let flat = lines.join(" ");
    if lines.len() > 1 {
        lines.iter_mut().skip(1).step_by(2).for_each(|line| line.insert_str(0, "    "));
    }
    Statement { flat, lines }
}
