//! The names of everything in one file.

use super::literals::time;
use crate::comment::clean;
use crate::keywords::Family;
use crate::namer::Namer;
use ecow::{EcoString, eco_format};
use grafc_logic::misleading_points;
use grafc_logic::scan::{Preset, Program, Role, TimerId, VarId};
use index_vec::IndexVec;

/// All names, each unique in the whole file: readers search for them, and some tools mix up scopes.
#[derive(Clone)]
pub(crate) struct Names {
    pub variables: IndexVec<VarId, EcoString>,
    pub timers: IndexVec<TimerId, EcoString>,
    pub block: EcoString,
    pub program: EcoString,
    pub instance: EcoString,
    pub configuration: EcoString,
    pub resource: EcoString,
    pub task: EcoString,
    pub program_instance: EcoString,
    /// Gives further names: labels, variables of the target's own.
    pub namer: Namer,
}

impl Names {
    /// Names by rank: what the chart declares, the chart, what is published, what is ours.
    pub fn new(program: &Program, family: Family) -> Self {
        let mut namer = Namer::new(family);
        let mut variables: IndexVec<VarId, EcoString> = program.variables.iter().map(|_| EcoString::new()).collect();
        name_rank(&mut namer, program, &mut variables, 0);
        let block = namer.unit(&program.name);
        name_rank(&mut namer, program, &mut variables, 1);
        name_rank(&mut namer, program, &mut variables, 2);
        let timers = program.timers.iter().map(|timer| namer.name(&timer.name)).collect();
        Names {
            variables,
            timers,
            program: namer.unit(&format!("{block}_program")),
            instance: namer.name("chart"),
            configuration: namer.unit(&format!("{block}_configuration")),
            resource: namer.name("resource_1"),
            task: namer.name("cycle"),
            program_instance: namer.name("main"),
            block,
            namer,
        }
    }
}

impl Names {
    /// How long a timer with this preset runs.
    pub fn preset(&self, preset: Preset) -> EcoString {
        preset.constant.map_or_else(|| time(preset.ms), |constant| self.variables[constant].clone())
    }

    /// The same names, variables and timers with a mark before them.
    pub fn marked(&self, mark: &str) -> Names {
        Names {
            variables: self.variables.iter().map(|name| eco_format!("{mark}{name}")).collect(),
            timers: self.timers.iter().map(|name| eco_format!("{mark}{name}")).collect(),
            ..self.clone()
        }
    }
}

/// Names the variables of one rank, in order.
fn name_rank(namer: &mut Namer, program: &Program, variables: &mut IndexVec<VarId, EcoString>, wanted: u8) {
    let of_rank = || program.variables.iter_enumerated().filter(|(_, variable)| rank(variable.role) == wanted);
    let given = namer.names(of_rank().map(|(_, variable)| variable.name.clone()));
    for ((id, _), name) in of_rank().zip(given) {
        variables[id] = name;
    }
}

fn rank(role: Role) -> u8 {
    match role {
        Role::Input | Role::Output | Role::Internal | Role::Constant | Role::Step => 0,
        Role::Flag(_) => 1,
        Role::State | Role::Memory | Role::Temporary | Role::Observed => 2,
    }
}

/// What stands beside a declaration: the chart's name if it had to be changed, and the attached comment.
pub(crate) fn remark(original: &str, given: &str, comment: Option<&str>) -> Option<String> {
    let comment = comment.map(clean).filter(|text| !text.is_empty());
    if original == given {
        return comment;
    }
    // What looks like something else is told by its numbers.
    let points = misleading_points(original).map(|points| format!(" ({points})")).unwrap_or_default();
    let original = clean(original);
    Some(match comment {
        Some(comment) => clean(&format!("`{original}`{points}: {comment}")),
        None => format!("`{original}`{points}"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_misleads_has_its_code_points_beside_it() {
        assert_eq!(remark("Tür", "Tuer", None).as_deref(), Some("`Tür`"));
        assert_eq!(remark("p\u{430}ge", "page", None).as_deref(), Some("`p\u{430}ge` (U+0430)"));
        assert_eq!(remark("pu\u{200B}mp", "pump", Some("cold")).as_deref(), Some("`pu mp` (U+200B): cold"));
    }
}
