//! Single words of other languages, and ours in their place.

/// A word of ours, and what others call it, in small letters.
pub type Row = (&'static str, &'static [&'static str]);

/// Types, of IEC 61131-3 as far as we have none of that name, of C and Rust, and in words.
pub const TYPES: &[Row] = &[
    ("bool", &["boolean", "bit", "flag", "logical", "booléen", "booleen", "boolesch"]),
    ("int", &["integer", "short", "sint", "int16", "i16", "entier", "ganzzahl", "counter"]),
    ("dint", &["long", "lint", "int32", "i32"]),
    ("uint", &["unsigned", "word", "byte", "usint", "uint16", "u16"]),
    ("udint", &["dword", "ulint", "lword", "uint32", "u32"]),
    ("real", &["float", "single", "f32", "réel", "reel"]),
    ("lreal", &["double", "f64"]),
    ("time", &["timer", "duration", "ltime", "s5time", "ton", "tof", "tp", "temps", "zeit"]),
];

/// Units of durations.
pub const UNITS: &[Row] = &[
    ("d", &["d", "day", "days", "tag", "tage", "jour", "jours"]),
    ("h", &["h", "hr", "hrs", "hour", "hours", "std", "stunde", "stunden", "heure", "heures"]),
    ("min", &["min", "m", "mn", "mins", "minute", "minutes", "minuten"]),
    ("s", &["s", "sec", "secs", "second", "seconds", "sek", "sekunde", "sekunden", "seconde", "secondes"]),
    ("ms", &["ms", "msec", "msecs", "millis", "millisecond", "milliseconds", "millisekunden", "millisecondes"]),
];

/// Operators between and before conditions.
pub const OPERATORS: &[Row] = &[
    ("and", &["and", "et", "und", "y"]),
    ("or", &["or", "ou", "oder"]),
    ("xor", &["xor"]),
    ("not", &["not", "non", "nicht", "pas", "no"]),
    ("mod", &["mod", "modulo"]),
];

/// Functions that are signs here.
pub const FUNCTIONS: &[Row] = &[
    ("↑", &["r_trig", "rising", "rising_edge", "re", "r_edge", "posedge", "fm", "front_montant", "flanke"]),
    ("↓", &["f_trig", "falling", "falling_edge", "fe", "f_edge", "negedge", "fd", "front_descendant"]),
    ("not ", &["non", "nicht", "not"]),
];

/// What an assignment is done at.
pub const EVENTS: &[Row] = &[
    ("activation", &["entry", "enter", "activate", "activated", "activating", "start", "begin", "aktivierung"]),
    ("deactivation", &["exit", "leave", "deactivate", "deactivated", "end", "deaktivierung", "désactivation"]),
];

/// Words that stand where an item begins.
pub const ITEMS: &[Row] = &[
    ("step", &["state", "place", "steps", "etape", "étape", "schritt", "etapa", "node"]),
    ("initial step", &["initialstep", "initial_step", "init_step", "initstep", "anfangsschritt", "initialschritt"]),
    ("initial", &["init", "initiale", "initially"]),
    ("macro step", &["macrostep", "macro_step", "makroschritt", "macroétape", "macroetape"]),
    ("transition", &["trans", "transitions", "übergang", "transicion", "arc", "edge"]),
    ("input", &["in", "inputs", "var_input", "entrée", "entree", "entrées", "eingang", "eingänge", "entrada"]),
    ("output", &["out", "outputs", "var_output", "sortie", "sorties", "ausgang", "ausgänge", "salida"]),
    (
        "var",
        &["variable", "variables", "vars", "internal", "local", "let", "merker", "memory", "var_temp", "var_global"],
    ),
    ("const", &["constant", "constants", "constante", "konstante", "define", "var_constant"]),
    ("grafcet", &["sfc", "graph", "enclosure", "sequence", "subchart", "network", "partial"]),
    ("chart", &["program", "function_block", "project", "title", "model"]),
    ("expansion", &["expand", "expanded", "entfaltung"]),
    ("enclosing", &["enclose", "encloses", "encapsulating", "einschließend", "encapsulante"]),
];

/// Ours for a word of others, in any case.
pub fn ours(table: &[Row], word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    table.iter().find(|(_, theirs)| theirs.contains(&word.as_str())).map(|(ours, _)| *ours)
}

/// What an action qualifier of IEC 61131-3 makes of an action.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Qualifier {
    /// `N`: while the step is active.
    Continuous,
    /// `S`
    Set,
    /// `R`
    Reset,
    /// `D`
    Delayed,
    /// `L`
    Limited,
    /// `DS`
    DelayedSet,
    /// `P`, `P1`: once, at the start.
    Pulse,
    /// `P0`: once, at the end.
    LastPulse,
    /// `SD`, `SL`: a time that goes on when the step has ended.
    StoredTime,
}

/// The qualifier of this spelling; also the words that the S7 languages and others have for it.
pub fn qualifier(word: &str) -> Option<Qualifier> {
    Some(match word {
        "N" => Qualifier::Continuous,
        "S" | "set" | "SET" | "Set" => Qualifier::Set,
        "R" | "reset" | "RESET" | "Reset" | "RST" => Qualifier::Reset,
        "D" => Qualifier::Delayed,
        "L" => Qualifier::Limited,
        "DS" => Qualifier::DelayedSet,
        "P" | "P1" => Qualifier::Pulse,
        "P0" => Qualifier::LastPulse,
        "SD" | "SL" => Qualifier::StoredTime,
        _ => return None,
    })
}

/// The action with a qualifier as it is written here: `K := 1 on activation` for `S K`. `time` is the duration beside
/// it, `step` the label of its step; a pulse and what needs a time that is not there have no other spelling.
pub fn qualified(qualifier: Qualifier, target: &str, time: Option<&str>, step: &str) -> Option<String> {
    match (qualifier, time) {
        (Qualifier::Continuous, None) => Some(target.to_owned()),
        (Qualifier::Set, None) => Some(format!("{target} := 1 on activation")),
        (Qualifier::Reset, None) => Some(format!("{target} := 0 on activation")),
        (Qualifier::Delayed, Some(time)) => Some(format!("{target} if {time}/X{step}")),
        (Qualifier::Limited, Some(time)) => Some(format!("{target} if not {time}/X{step}")),
        (Qualifier::DelayedSet, Some(time)) => Some(format!("{target} := 1 on event ↑({time}/X{step})")),
        (
            Qualifier::Continuous
            | Qualifier::Set
            | Qualifier::Reset
            | Qualifier::Delayed
            | Qualifier::Limited
            | Qualifier::DelayedSet
            | Qualifier::Pulse
            | Qualifier::LastPulse
            | Qualifier::StoredTime,
            _,
        ) => None,
    }
}
