//! Sets of inputs as conditions of a chart, and as cubes.

use crate::machine::{Alphabet, Set};

/// A condition of more paths than so many is cut short.
const TERMS: usize = 64;

/// A set as a condition: `x1 · ¬x2 + x3`, or `1` for all inputs and `0` for none.
pub fn condition(set: &Set, inputs: &[String]) -> String {
    if set.is_true() {
        return "1".to_owned();
    }
    if set.is_false() {
        return "0".to_owned();
    }
    let term = |literals: &Literals| {
        let factors =
            literals.iter().map(|(input, value)| format!("{}{}", if *value { "" } else { "¬" }, inputs[*input]));
        factors.collect::<Vec<_>>().join(" · ")
    };
    let (terms, is_cut) = terms(set, inputs.len());
    let cut = is_cut.then(|| "…".to_owned());
    terms.iter().map(term).chain(cut).collect::<Vec<_>>().join(" + ")
}

/// Inputs, each with the value that it has.
type Literals = Vec<(usize, bool)>;

/// Terms that together are the set, none of which can do without one of its factors or be left out; and whether there are
/// more of them.
fn terms(set: &Set, inputs: usize) -> (Vec<Literals>, bool) {
    let alphabet = Alphabet::new(inputs);
    let factor = |(input, value): (usize, bool)| {
        let variable = &alphabet.variables[input];
        if value { variable.clone() } else { variable.not() }
    };
    let product = |literals: &Literals| literals.iter().fold(alphabet.all.clone(), |set, one| set.and(&factor(*one)));
    let (mut found, mut covered): (Vec<(Literals, Set)>, Set) = (Vec::new(), alphabet.none.clone());
    let mut paths = set.sat_clauses();
    for clause in paths.by_ref().take(TERMS) {
        let mut literals: Literals =
            clause.to_values().into_iter().map(|(variable, value)| (variable.to_index(), value)).collect();
        if product(&literals).and_not(&covered).is_false() {
            continue;
        }
        for place in (0..literals.len()).rev() {
            let without: Literals = [&literals[..place], &literals[place + 1..]].concat();
            if product(&without).and_not(set).is_false() {
                literals = without;
            }
        }
        let term = product(&literals);
        covered = covered.or(&term);
        found.push((literals, term));
    }
    for place in (0..found.len()).rev() {
        let others = found.iter().enumerate().filter(|(other, _)| *other != place);
        let others = others.fold(alphabet.none.clone(), |set, (_, (_, term))| set.or(term));
        if found[place].1.and_not(&others).is_false() {
            found.remove(place);
        }
    }
    (found.into_iter().map(|(literals, _)| literals).collect(), paths.next().is_some())
}

/// Cubes that do not meet and together are the set: `1`, `0` or `-` for each input.
pub(crate) fn cubes(set: &Set, inputs: usize) -> impl Iterator<Item = String> + '_ {
    set.sat_clauses().map(move |clause| {
        let mut cube = vec!['-'; inputs];
        for (variable, value) in clause.to_values() {
            cube[variable.to_index()] = if value { '1' } else { '0' };
        }
        cube.into_iter().collect()
    })
}
