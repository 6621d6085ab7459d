//! A table as a chart of `evolution scan`: each call takes one row, which is a transition that gives every output its value.
//! A state has a step. With inputs that no row of a state has, it stays, and the outputs are false.
//!
//! Of rows that meet, the first one counts, and the others exclude it.

use super::table::{Cube, Row, Table};
use crate::naming::{Taken, clean, spell, spell_label};
use crate::write::Text;
use crate::{changed, doubtful};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// So many pairs of rows are compared; a table of more is not made by anybody.
const PAIRS: usize = 50_000_000;

/// The text of a chart; none if there is too much to compare or to write, which is said.
pub fn write(table: &Table, limit: usize, diagnostics: &mut Diagnostics) -> Option<String> {
    let too_much = |diagnostics: &mut Diagnostics, message: &str| {
        let fault = Diagnostic::new(Code::E0707, table.span, message);
        diagnostics.push(fault.help("leave out the rows that say nothing new"));
    };
    let Some(of_state) = rows_of_states(table) else {
        too_much(diagnostics, "a state has too many rows to compare them all");
        return None;
    };
    let names = Names::new(table, diagnostics);
    let mut text = Text::new(limit);
    text.push("chart Machine \"from a table of KISS2\" evolution scan\n\n");
    for (keyword, names) in [("input", &names.inputs), ("output", &names.outputs)] {
        if !names.is_empty() {
            text.push(&format!("{keyword} {} : bool\n", names.join(", ")));
        }
    }
    text.push("\n");
    for (state, label) in names.labels.iter().enumerate() {
        text.push(&format!("{}step {label}\n", if state == table.reset { "initial " } else { "" }));
    }
    for (state, rows) in of_state.iter().enumerate() {
        text.push("\n");
        for (place, row) in rows.iter().enumerate() {
            if text.is_full() {
                break;
            }
            let earlier = &rows[..place];
            if let Some(first) = earlier.iter().find(|other| other.cube.holds(&row.cube)) {
                let is_same = (first.to, &first.outputs) == (row.to, &row.outputs);
                let told = "an earlier row takes all inputs of this one";
                diagnostics.push(if is_same { changed(row.span, told) } else { doubtful(row.span, told) });
                continue;
            }
            let meeting: Vec<&Cube> =
                earlier.iter().filter(|other| other.cube.meets(&row.cube)).map(|other| &other.cube).collect();
            if earlier
                .iter()
                .any(|other| other.cube.meets(&row.cube) && (other.to, &other.outputs) != (row.to, &row.outputs))
            {
                let told = "an earlier row takes some inputs of this one, and does something else with them";
                diagnostics.push(doubtful(row.span, told));
            }
            if row.to.is_none() {
                diagnostics.push(doubtful(row.span, "the next state is left open: the state stays"));
            }
            let mut guard = names.cube(&row.cube);
            for other in meeting {
                guard = format!("{guard} and not ({})", names.cube(other));
            }
            names.transition(&mut text, state, row.to.unwrap_or(state), &guard, &row.outputs);
        }
        if !are_all(rows, table.inputs) {
            let cubes: Vec<String> = rows.iter().map(|row| names.cube(&row.cube)).collect();
            let guard = match cubes.as_slice() {
                [] => "1".to_owned(),
                cubes => format!("not ({})", cubes.join(" or ")),
            };
            names.transition(&mut text, state, state, &guard, &vec![false; table.outputs]);
        }
        if text.is_full() {
            too_much(diagnostics, "the chart of this table would be far longer than the table");
            return None;
        }
    }
    Some(text.out)
}

/// The rows of each state, with those of any state, in the order of the file; none if they are too many to compare all those
/// of a state with each other.
fn rows_of_states(table: &Table) -> Option<Vec<Vec<&Row>>> {
    let mut of_state: Vec<Vec<&Row>> = vec![Vec::new(); table.states.len()];
    let of_any = table.rows.iter().filter(|row| row.from.is_none()).count();
    if of_any.saturating_mul(table.states.len()) > PAIRS {
        return None;
    }
    for row in &table.rows {
        match row.from {
            Some(state) => of_state[state].push(row),
            None => of_state.iter_mut().for_each(|rows| rows.push(row)),
        }
    }
    let work = |rows: &Vec<&Row>| rows.len().saturating_mul(rows.len()).saturating_mul(table.inputs / 16 + 1);
    (of_state.iter().map(work).fold(0, usize::saturating_add) <= PAIRS).then_some(of_state)
}

/// Whether rows take all inputs, as far as counting tells: they do not meet, and are many enough.
fn are_all(rows: &[&Row], inputs: usize) -> bool {
    if rows.iter().any(|row| row.cube.open() == inputs) {
        return true;
    }
    let meet = |(place, row): (usize, &&Row)| rows[..place].iter().any(|other| other.cube.meets(&row.cube));
    if inputs > 100 || rows.iter().enumerate().any(meet) {
        return false;
    }
    rows.iter().map(|row| 1u128 << row.cube.open()).fold(0, u128::saturating_add) == 1 << inputs
}

/// Names as they are written.
struct Names {
    inputs: Vec<String>,
    outputs: Vec<String>,
    labels: Vec<String>,
}

impl Names {
    fn new(table: &Table, diagnostics: &mut Diagnostics) -> Names {
        let mut taken = Taken::default();
        let mut columns = |given: &[String], count: usize, plain: &str| -> Vec<String> {
            let name = |column: usize| given.get(column).map_or(format!("{plain}{}", column + 1), |name| clean(name));
            (0..count).map(|column| spell(&taken.take(&name(column)))).collect()
        };
        let inputs = columns(&table.input_names, table.inputs, "in");
        let outputs = columns(&table.output_names, table.outputs, "out");
        let mut labels = Vec::with_capacity(table.states.len());
        for state in &table.states {
            let wanted = clean(state);
            let made = |label: &str| vec![label.to_owned(), format!("X{label}"), format!("T{label}")];
            let label = taken.take_all(&wanted, made);
            if label != *state {
                diagnostics.push(changed(table.span, format!("the state `{wanted}` is the step `{label}`")));
            }
            labels.push(spell_label(&label));
        }
        Names { inputs, outputs, labels }
    }

    /// A cube as a condition.
    fn cube(&self, cube: &Cube) -> String {
        let given = self.inputs.iter().zip(&cube.0);
        let factors = given.filter_map(|(name, value)| match value {
            Some(true) => Some(name.clone()),
            Some(false) => Some(format!("not {name}")),
            None => None,
        });
        let factors: Vec<String> = factors.collect();
        if factors.is_empty() { "1".to_owned() } else { factors.join(" and ") }
    }

    fn transition(&self, text: &mut Text, from: usize, to: usize, guard: &str, outputs: &[bool]) {
        text.push(&format!("transition {} -> {} : {guard}", self.labels[from], self.labels[to]));
        if !outputs.is_empty() {
            let given = self.outputs.iter().zip(outputs);
            let given = given.map(|(name, value)| format!("{name} := {}", u8::from(*value)));
            text.push(&format!(" {{ {} }}", given.collect::<Vec<_>>().join("  ")));
        }
        text.push("\n");
    }
}
