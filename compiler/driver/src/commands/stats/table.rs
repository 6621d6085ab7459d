//! Figures as text for people.

use super::figures::{Decomposition, EncodingFigures, Figures, Repeat, Transients, Worst};

/// Lines are at most this long, except for a name that is longer.
const WIDTH: usize = 100;

/// The heads of the table; the first column is aligned to the left, the others to the right.
const HEADS: [&str; 10] = [
    "encoding",
    "state bits",
    "states",
    "aux bits",
    "aux nums",
    "delays",
    "loop",
    "statements",
    "instructions",
    "in IL",
];

impl Figures {
    pub fn json(&self) -> String {
        // Strings and numbers alone cannot be refused.
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }

    pub fn table(&self) -> String {
        let mut rows = vec![HEADS.map(str::to_string)];
        rows.extend(self.encodings.iter().map(EncodingFigures::cells));
        let widths: Vec<usize> =
            (0..HEADS.len()).map(|column| rows.iter().map(|row| row[column].len()).max().unwrap_or_default()).collect();
        let steps = counted(self.steps, "step", "steps");
        let transitions = counted(self.transitions, "transition", "transitions");
        let mut out = format!("{}: {steps}, {transitions}, evolution {}\n\n", self.chart, self.evolution);
        for row in &rows {
            for (column, (cell, width)) in row.iter().zip(&widths).enumerate() {
                match column {
                    0 => out.push_str(&format!("{cell:<width$}")),
                    _ => out.push_str(&format!("  {cell:>width$}")),
                }
            }
            out.push('\n');
        }
        let by_encoding = |figure: &dyn Fn(&EncodingFigures) -> String| {
            let all: Vec<String> =
                self.encodings.iter().map(|row| format!("{} {}", row.encoding, figure(row))).collect();
            all.join(", ")
        };
        let awl = |row: &EncodingFigures| row.awl_instructions.map_or("none".to_string(), |count| count.to_string());
        out.push_str(&format!("\nin AWL\n  {}\n", by_encoding(&awl)));
        out.push_str(&format!("\nbytes in Rust\n  {}\n", by_encoding(&|row| row.rust_bytes.to_string())));
        let worst = |row: &EncodingFigures| {
            let Worst { micro_steps, statements } = row.worst_case;
            format!("{micro_steps} and {statements}")
        };
        out.push_str("\nmicro-steps and statements of the longest call\n");
        let worst: Vec<String> = self.encodings.iter().map(|row| format!("{} {}", row.encoding, worst(row))).collect();
        wrap(&mut out, "", 2, &worst.join(", ").split(' ').collect::<Vec<_>>());
        self.transients.list(&mut out);
        let by_method: Vec<String> = self
            .exclusion
            .iter()
            .map(|found| format!("{} of {}", found.method, counted(found.steps, "step", "steps")))
            .collect();
        out.push_str(&format!("\nwhich steps exclude each other, by\n  {}\n", by_method.join(", ")));
        self.switch.list(&mut out);
        out
    }
}

impl EncodingFigures {
    fn cells(&self) -> [String; HEADS.len()] {
        let repeat = match &self.repeat {
            None => "none".to_string(),
            Some(Repeat { bound: Some(bound) }) => bound.to_string(),
            Some(Repeat { bound: None }) => "ends".to_string(),
        };
        [
            self.encoding.to_string(),
            self.state_bits.to_string(),
            self.states.len().to_string(),
            self.auxiliary_bits.to_string(),
            self.auxiliary_numbers.to_string(),
            self.delays.to_string(),
            repeat,
            self.statements.to_string(),
            self.instructions.to_string(),
            self.il_instructions.to_string(),
        ]
    }
}

impl Decomposition {
    /// The variables with their steps, and the steps that stay bits.
    fn list(&self, out: &mut String) {
        if !self.states.is_empty() {
            out.push_str("\nsteps in switch\n");
        }
        let names = self.states.iter().map(|state| state.name.len());
        let indent = 4 + names.max().unwrap_or_default();
        for state in &self.states {
            let mut words: Vec<&str> = state.steps.iter().map(String::as_str).collect();
            words.extend(state.idle.then_some("(or none)"));
            wrap(out, &state.name, indent, &words);
        }
        if self.bits.is_empty() {
            return;
        }
        out.push_str("\nsteps that stay bits\n");
        let indent = 4 + self.bits.iter().map(|bit| bit.step.len()).max().unwrap_or_default();
        for bit in &self.bits {
            wrap(out, &bit.step, indent, &bit.because.split(' ').collect::<Vec<_>>());
        }
    }
}

impl Transients {
    /// How an evolution to stability ends, and what shows it.
    fn list(&self, out: &mut String) {
        /// No more transitions than this are shown.
        const SHOWN: usize = 8;
        let (text, arrows) = match self.longest {
            _ if self.single => ("one micro-step is always enough".to_owned(), &[][..]),
            Some(longest) if self.chain.is_empty() => (format!("ends after at most {longest} micro-steps"), &[][..]),
            Some(longest) => (format!("ends after at most {longest} micro-steps, as after"), self.chain.as_slice()),
            None if self.cycle.is_empty() => ("no bound is known".to_owned(), &[][..]),
            None => ("no bound is known: these may clear in a circle:".to_owned(), self.cycle.as_slice()),
        };
        // An arrow is not broken between two lines.
        let mut words: Vec<String> = text.split(' ').map(str::to_owned).collect();
        for (place, arrow) in arrows.iter().take(SHOWN).enumerate() {
            words.push(format!("`{arrow}`{}", if place + 1 < arrows.len() { "," } else { "" }));
        }
        words.extend((arrows.len() > SHOWN).then(|| "…".to_owned()));
        out.push_str("\nevolution to stability\n");
        wrap(out, "", 2, &words.iter().map(String::as_str).collect::<Vec<_>>());
    }
}

/// `1 step`, `2 steps`.
pub fn counted(n: usize, one: &str, several: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { several })
}

/// A name, and words beside it in as many lines as they need.
pub fn wrap(out: &mut String, name: &str, indent: usize, words: &[&str]) {
    let mut line = format!("{:<indent$}", format!("  {name}"));
    let mut bare = true;
    for word in words {
        if !bare && line.chars().count() + 1 + word.chars().count() > WIDTH {
            out.push_str(&line);
            out.push('\n');
            line = " ".repeat(indent);
            bare = true;
        }
        if !bare {
            line.push(' ');
        }
        line.push_str(word);
        bare = false;
    }
    out.push_str(line.trim_end());
    out.push('\n');
}
