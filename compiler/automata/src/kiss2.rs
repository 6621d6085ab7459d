//! A machine as a table of KISS2, the format of the MCNC benchmarks: a row has a cube of inputs, a state, the next state, and
//! the outputs.

use crate::call::Beyond;
use crate::machine::Machine;
use crate::mealy::rows;
use crate::words::cubes;
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// The table, if it has no more than so many rows. The first state is the one in which the first call begins.
///
/// # Errors
/// It has more rows.
pub fn kiss2(machine: &Machine, most: usize) -> Result<String, Beyond> {
    let names = names(machine);
    let (mut table, mut count) = (String::new(), 0);
    for (from, state) in machine.states.iter().enumerate() {
        for row in rows(state) {
            let outputs: String = row.outputs.iter().map(|value| if *value { '1' } else { '0' }).collect();
            for cube in cubes(&row.when, machine.inputs.len()) {
                count += 1;
                if count > most {
                    return Err(Beyond::Rows(most));
                }
                // Writing to memory does not fail.
                let _ = writeln!(table, "{cube} {} {} {outputs}", names[from], names[row.to]);
            }
        }
    }
    let listed = |names: &[String]| names.iter().map(|name| word(name)).collect::<Vec<_>>().join(" ");
    let (i, o, s) = (machine.inputs.len(), machine.outputs.len(), machine.states.len());
    let mut out = format!(".i {i}\n.o {o}\n.p {count}\n.s {s}\n.r {}\n", names[machine.initial]);
    if i > 0 {
        let _ = writeln!(out, ".ilb {}", listed(&machine.inputs));
    }
    if o > 0 {
        let _ = writeln!(out, ".ob {}", listed(&machine.outputs));
    }
    Ok(out + &table + ".e\n")
}

/// What stands for a name in a line of words.
fn word(name: &str) -> String {
    name.chars().map(|c| if c.is_whitespace() || c == '#' { '_' } else { c }).collect()
}

/// A word of its own for each state.
fn names(machine: &Machine) -> Vec<String> {
    let mut taken: BTreeSet<String> = BTreeSet::new();
    let free = |state: &crate::machine::State| {
        let plain = word(&state.name);
        let mut name = if plain.is_empty() { "s".to_owned() } else { plain.clone() };
        let mut number = 1;
        while !taken.insert(name.clone()) {
            number += 1;
            name = format!("{plain}_{number}");
        }
        name
    };
    machine.states.iter().map(free).collect()
}
