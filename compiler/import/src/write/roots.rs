//! Which programs of a file are charts of their own, and not children of others.

use super::children::named;
use super::maker::Command;
use crate::Dialect;
use crate::code::tree::StatementKind;
use crate::sfc::{Body, Project, Target};
use rustc_hash::{FxHashMap, FxHashSet};

/// The units among some that no other commands, as far as their texts tell; of those that command each other the first.
pub fn roots(project: &Project, dialect: Dialect, chosen: &[usize]) -> Vec<usize> {
    let units: FxHashMap<String, usize> =
        project.units.iter().enumerate().map(|(place, unit)| (unit.name.to_lowercase(), place)).collect();
    let mut commands: Vec<Vec<usize>> = vec![Vec::new(); project.units.len()];
    for &unit in chosen {
        let own = &project.units[unit];
        let bodies = own.actions.iter().filter_map(|action| match &action.body {
            Body::Statements(statements) => Some(statements),
            Body::Chart(_) => None,
        });
        let associations = || own.charts().flat_map(|chart| &chart.steps).flat_map(|step| &step.actions);
        let inline = associations().filter_map(|association| match &association.action {
            Target::Inline(statements) => Some(statements),
            Target::Named(_) => None,
        });
        let called = bodies.chain(inline).flatten().filter_map(|statement| match &statement.kind {
            StatementKind::Call(name, arguments) if Command::of(name).is_some() => named(project, arguments),
            _ => None,
        });
        let actions = associations().filter_map(|association| match &association.action {
            Target::Named(name) if dialect == Dialect::Isagraf => Some(name.as_str()),
            Target::Named(_) | Target::Inline(_) => None,
        });
        let all = called.chain(actions).filter_map(|name| units.get(&name.to_lowercase()));
        commands[unit].extend(all.filter(|other| **other != unit));
    }
    let commanded: FxHashSet<usize> = commands.iter().flatten().copied().collect();
    let mut roots = Vec::new();
    let mut reached = vec![false; project.units.len()];
    let first = chosen.iter().filter(|unit| !commanded.contains(unit));
    for &root in first.chain(chosen) {
        if reached[root] {
            continue;
        }
        roots.push(root);
        let mut open = vec![root];
        while let Some(unit) = open.pop() {
            if !std::mem::replace(&mut reached[unit], true) {
                open.extend(&commands[unit]);
            }
        }
    }
    roots
}
