//! The inputs of paths, as a condition.

use crate::atom::Atom;
use biodivine_lib_bdd::{Bdd, BddPartialValuation, BddVariable, BddVariableSet};
use grafc_logic::scan::Program;

/// The answers of a path, in order of the questions; those on time left out.
pub(crate) type Answers = Vec<(Atom, bool)>;

/// Writes conditions on inputs.
pub(crate) struct When<'p> {
    program: &'p Program,
    /// All questions, inputs in order of declaration.
    atoms: Vec<Atom>,
    variables: BddVariableSet,
}

impl<'p> When<'p> {
    /// For answers to these questions.
    pub(crate) fn new(program: &'p Program, atoms: impl IntoIterator<Item = Atom>) -> Self {
        let mut atoms: Vec<Atom> = atoms.into_iter().collect();
        atoms.sort_unstable();
        atoms.dedup();
        let variables = BddVariableSet::new_anonymous(u16::try_from(atoms.len()).unwrap_or(u16::MAX - 1));
        When { program, atoms, variables }
    }

    /// True exactly if the inputs agree with one of the paths; as short a disjunction as is found.
    pub(crate) fn text<'a>(&self, paths: impl IntoIterator<Item = &'a Answers>) -> String {
        let clauses: Vec<BddPartialValuation> = paths.into_iter().map(|path| self.clause(path)).collect();
        let any: Bdd = self.variables.mk_dnf(&clauses);
        if any.is_true() {
            return "true".to_string();
        }
        let mut terms: Vec<Vec<(usize, bool)>> = any.to_optimized_dnf().iter().map(literals).collect();
        // What is asked to be true comes first.
        terms.sort_by_key(|term| term.iter().map(|(atom, answer)| (*atom, !answer)).collect::<Vec<_>>());
        let terms: Vec<String> = terms.iter().map(|term| self.term(term)).collect();
        terms.join(" or ")
    }

    fn clause(&self, path: &Answers) -> BddPartialValuation {
        let mut clause = BddPartialValuation::empty();
        for (atom, answer) in path {
            if let Ok(place) = self.atoms.binary_search(atom) {
                clause.set_value(BddVariable::from_index(place), *answer);
            }
        }
        clause
    }

    fn term(&self, term: &[(usize, bool)]) -> String {
        let literals: Vec<String> =
            term.iter().map(|(atom, answer)| self.literal(self.atoms[*atom], *answer)).collect();
        literals.join(" and ")
    }

    fn literal(&self, atom: Atom, answer: bool) -> String {
        match atom {
            Atom::Holds(v) if answer => self.program.variables[v].name.to_string(),
            Atom::Holds(v) => format!("not {}", self.program.variables[v].name),
            Atom::AtLeast(v, bound) => {
                let variable = &self.program.variables[v];
                format!("[{} {}]", variable.name, bound.spelled(variable.ty, answer))
            }
            // Numbers are taken apart in proofs alone.
            Atom::Bit(v, bit) => format!("{}.{bit}", self.program.variables[v].name),
            // They are left out of answers.
            Atom::Ends(operand, time) => format!("{time}ms/{operand}"),
        }
    }
}

fn literals(term: &BddPartialValuation) -> Vec<(usize, bool)> {
    term.to_values().into_iter().map(|(variable, value)| (variable.to_index(), value)).collect()
}
