//! Saving all memory of a chart as bytes, and going on with it: only with that of this very program, only if not a bit of
//! it has changed, and only if it is a situation that the chart can be in.
//!
//! A fingerprint of the program, the values one after the other, the lowest byte first, a checksum.

use super::literals::type_name;
use super::places::Places;
use super::scan::restores;
use crate::types::size;
use crate::writer::Writer;
use grafc_formula::{Type, Value};
use grafc_logic::scan::{Exclusive, Program, TimerId, VarId};

/// The bytes of the fingerprint, and of the checksum.
const AROUND: usize = 8 + 4;
/// The bytes of a delay.
const DELAY: usize = 1 + 8;

/// A value of the memory.
#[derive(Clone, Copy)]
enum Piece {
    Variable(VarId),
    Timer(TimerId),
}

/// How many bytes it takes.
pub(super) fn length(program: &Program, kept: &[VarId]) -> usize {
    let states = program.state_of();
    let bytes = |piece: &Piece| match piece {
        Piece::Variable(id) if states.contains_key(id) => 4,
        Piece::Variable(id) => size(program.variables[*id].ty),
        Piece::Timer(_) => DELAY,
    };
    AROUND + pieces(program, kept).iter().map(bytes).sum::<usize>()
}

/// Everything that keeps its value, except what follows from the rest; inputs first.
fn pieces(program: &Program, kept: &[VarId]) -> Vec<Piece> {
    let derived = program.derived();
    let is_kept = |id: &VarId| program.variables[*id].role.is_kept() && !derived.contains(id);
    let variables = kept.iter().copied().chain(program.variables.indices().filter(is_kept)).map(Piece::Variable);
    variables.chain(program.timers.indices().map(Piece::Timer)).collect()
}

/// Writes `save` and `restore`.
pub(super) fn write(out: &mut Writer, places: &Places, kept: &[VarId]) {
    let program = places.program;
    let saved = Saved { program, places };
    let pieces = pieces(program, kept);
    saved.save(out, &pieces);
    let exclusive = program.restoring.as_ref().map(|restoring| &restoring.exclusive[..]).unwrap_or_default();
    if !exclusive.is_empty() {
        saved.is_possible(out, exclusive);
    }
    saved.restore(out, &pieces, !exclusive.is_empty());
}

struct Saved<'p> {
    program: &'p Program,
    places: &'p Places<'p>,
}

impl Saved<'_> {
    fn save(&self, out: &mut Writer, pieces: &[Piece]) {
        let chart = &self.places.names.chart;
        out.blank();
        out.comment("which program saved bytes belong to: another chart, or encoding, has another");
        out.line(&format!("static const uint64_t FINGERPRINT = 0x{:016x}u;", self.program.fingerprint()));
        out.blank();
        out.open(&format!("void {chart}_save(const {chart} *chart, uint8_t *bytes)\n{{"));
        out.line("uint32_t at = 0u;");
        out.blank();
        out.line("at = put(bytes, at, FINGERPRINT, 8u);");
        for piece in pieces {
            match *piece {
                Piece::Variable(id) => {
                    let (place, ty) = (self.places.read(id), self.program.variables[id].ty);
                    if self.places.state(id).is_some() {
                        out.line(&format!("at = put_state(bytes, at, (int32_t){place});"));
                        continue;
                    }
                    let (value, count) = match ty {
                        Type::Bool => (format!("{place} ? 1u : 0u"), 1),
                        Type::Int => (format!("(uint16_t){place}"), 2),
                        Type::Dint => (format!("(uint32_t){place}"), 4),
                        Type::Uint | Type::Udint => (place.to_string(), size(ty)),
                        Type::Time => (format!("(uint64_t){place}"), 8),
                        Type::Real => (format!("bits_of_real({place})"), 4),
                        Type::Lreal => (format!("bits_of_lreal({place})"), 8),
                    };
                    out.line(&format!("at = put(bytes, at, {value}, {count}u);"));
                }
                Piece::Timer(id) => {
                    let timer = self.places.timer(id);
                    out.line(&format!("at = put(bytes, at, {timer}.running ? 1u : 0u, 1u);"));
                    out.line(&format!("at = put(bytes, at, (uint64_t){timer}.elapsed, 8u);"));
                }
            }
        }
        out.line("(void)put(bytes, at, checksum(bytes, at), 4u);");
        out.close("}");
    }

    fn restore(&self, out: &mut Writer, pieces: &[Piece], asks_whether_possible: bool) {
        let (chart, capitals) = (&self.places.names.chart, &self.places.names.capitals);
        let is_state = |piece: &Piece| matches!(piece, Piece::Variable(id) if self.places.state(*id).is_some());
        out.blank();
        out.open(&format!("bool {chart}_restore({chart} *chart, const uint8_t *bytes, uint32_t now_ms)\n{{"));
        out.line("uint32_t at = 0u;");
        out.line("bool is_right = true;");
        if pieces.iter().any(is_state) {
            out.line("int32_t value;");
        }
        out.blank();
        if self.program.timers.is_empty() {
            out.line("(void)now_ms;");
        }
        out.line(&format!("{chart}_init(chart);"));
        out.open(&format!("if (take(bytes, &at, 8u) != FINGERPRINT || !sealed(bytes, {capitals}_SAVED_LEN)) {{"));
        out.line("return false;");
        out.close("}");
        for piece in pieces {
            match *piece {
                Piece::Variable(id) => self.take(out, id),
                Piece::Timer(id) => {
                    let timer = self.places.timer(id);
                    let line = "= take(bytes, &at, 1u) == 1u;";
                    out.line(&format!("{timer}.running {line}"));
                    out.line(&format!("{timer}.elapsed = to_time(take(bytes, &at, 8u));"));
                    out.line(&format!("{timer}.last = now_ms;"));
                    out.line(&format!(
                        "is_right = is_right && {timer}.elapsed >= 0 && ({timer}.running || {timer}.elapsed == 0);"
                    ));
                }
            }
        }
        let possible = if asks_whether_possible { " || !is_possible(chart)" } else { "" };
        out.open(&format!("if (!is_right{possible}) {{"));
        out.line(&format!("{chart}_init(chart);"));
        out.line("return false;");
        out.close("}");
        if restores(self.program) {
            let begun = self.program.started.map(|started| self.places.read(started).clone());
            if let Some(begun) = &begun {
                out.open(&format!("if ({begun}) {{"));
            }
            out.comment("what is computed for this raises no flag");
            out.line(&format!("const {chart}_flags flags = chart->flags;"));
            out.blank();
            out.line("restoring(chart);");
            out.line("chart->flags = flags;");
            if begun.is_some() {
                out.close("}");
            }
        }
        out.line("return true;");
        out.close("}");
    }

    fn take(&self, out: &mut Writer, id: VarId) {
        let (place, ty) = (self.places.read(id), self.program.variables[id].ty);
        if let Some(state) = self.places.state(id) {
            // What it was before the first scan may be no value of it.
            let mut values: Vec<i64> = state.constants.iter().map(|(value, _)| *value).collect();
            values.extend(match self.program.variables[id].initial() {
                Value::Int(n) => Some(n),
                Value::Bool(_) | Value::Real(_) | Value::Time(_) => None,
            });
            values.sort_unstable();
            values.dedup();
            out.line("value = to_dint((uint32_t)take(bytes, &at, 4u));");
            let ranges = ranges(&values);
            out.line(&format!("is_right = is_right && ({});", ranges.join(" || ")));
            out.line(&format!("{place} = ({})value;", state.ty));
            return;
        }
        let value = match ty {
            Type::Bool => "take_bool(bytes, &at, &is_right)".to_owned(),
            Type::Int => "to_int((uint32_t)take(bytes, &at, 2u))".to_owned(),
            Type::Dint => "to_dint((uint32_t)take(bytes, &at, 4u))".to_owned(),
            Type::Uint | Type::Udint => format!("({})take(bytes, &at, {}u)", type_name(ty), size(ty)),
            Type::Time => "to_time(take(bytes, &at, 8u))".to_owned(),
            Type::Real => "real_of_bits((uint32_t)take(bytes, &at, 4u))".to_owned(),
            Type::Lreal => "lreal_of_bits(take(bytes, &at, 8u))".to_owned(),
        };
        out.line(&format!("{place} = {value};"));
    }

    /// Writes the function that tells whether active steps can be active together.
    fn is_possible(&self, out: &mut Writer, exclusive: &[Exclusive]) {
        let (chart, capitals) = (&self.places.names.chart, &self.places.names.capitals);
        let mut set_of = vec![0_usize; self.program.steps.len()];
        for (number, set) in (1..).zip(exclusive) {
            set.steps.iter().for_each(|s| set_of[s.index()] = number);
        }
        let always = exclusive.iter().take_while(|set| set.always).count();
        let ty = match exclusive.len() {
            0..256 => "uint8_t",
            256..65536 => "uint16_t",
            _ => "uint32_t",
        };
        out.blank();
        out.comment("whether the active steps can be active together");
        out.open(&format!("static bool is_possible(const {chart} *chart)\n{{"));
        out.comment("for each step the number of the set that it excludes the others of; 0 is none");
        let numbers: Vec<String> = set_of.iter().map(|set| format!("{set}u")).collect();
        out.open(&format!("static const {ty} SETS[] = {{"));
        numbers.chunks(16).enumerate().for_each(|(place, row)| {
            let comma = if (place + 1) * 16 < numbers.len() { "," } else { "" };
            out.line(&format!("{}{comma}", row.join(", ")));
        });
        out.close("};");
        out.line(&format!("bool taken[{}];", exclusive.len()));
        out.line("uint32_t place;");
        out.blank();
        out.open(&format!("for (place = 0u; place < {}u; place++) {{", exclusive.len()));
        out.line("taken[place] = false;");
        out.close("}");
        out.open(&format!("for (place = 0u; place < {capitals}_STEP_COUNT; place++) {{"));
        out.line(&format!("const {ty} set = SETS[place];"));
        out.blank();
        out.open(&format!("if (set > 0u && {chart}_is_active(chart, ({chart}_step)place)) {{"));
        out.open("if (taken[set - 1u]) {");
        out.line("return false;");
        out.close("}");
        out.line("taken[set - 1u] = true;");
        out.close("}");
        out.close("}");
        if let Some(started) = self.program.started.filter(|_| always > 0) {
            out.comment("of the first sets, one step is always active");
            out.open(&format!("for (place = 0u; place < {always}u; place++) {{"));
            out.open(&format!("if ({} && !taken[place]) {{", self.places.read(started)));
            out.line("return false;");
            out.close("}");
            out.close("}");
        }
        out.line("return true;");
        out.close("}");
    }
}

/// What asks whether `value` is one of some numbers, run by run.
fn ranges(values: &[i64]) -> Vec<String> {
    let mut runs: Vec<(i64, i64)> = Vec::new();
    for value in values {
        match runs.last_mut() {
            Some((_, last)) if *last + 1 == *value => *last = *value,
            Some(_) | None => runs.push((*value, *value)),
        }
    }
    let several = runs.len() > 1;
    let run = |(first, last): (i64, i64)| match (first, last) {
        (first, last) if first == last => format!("value == {first}"),
        (first, last) if several => format!("(value >= {first} && value <= {last})"),
        (first, last) => format!("value >= {first} && value <= {last}"),
    };
    runs.into_iter().map(run).collect()
}
