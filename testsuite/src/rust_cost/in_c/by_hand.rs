//! The rings as an engineer would write them in C: an enum a ring says which step is active, and a `switch` has a case a
//! step, in which a transition moves the enum and two outputs.
//!
//! Names and the signature of a scan are those of generated code, so that one program times both. The outputs of the
//! initial steps are set from the start. Each ring has a function that says whether a transition cleared, and the
//! evolution to stability calls them until none has.

use crate::rings::Rings;
use grafc_model::reaction::Evolution;
use std::fmt::Write as _;
use std::ops::Range;

/// A source and its header.
pub(super) fn write(rings: Rings, evolution: Evolution) -> (String, String) {
    (source(rings, evolution), header(rings))
}

fn header(rings: Rings) -> String {
    let mut out = String::from("#include <stdbool.h>\n#include <stdint.h>\n\ntypedef struct {\n");
    for i in 0..rings.steps {
        let _ = writeln!(out, "    bool x_{i};");
    }
    if rings.walked < rings.length() {
        out.push_str("    bool aside;\n");
    }
    out.push_str("} Ring_inputs;\n\ntypedef struct {\n");
    for i in 0..rings.steps {
        let _ = writeln!(out, "    bool w_{i};");
    }
    out.push_str("} Ring_outputs;\n\n");
    for ring in 0..rings.tokens {
        let all: Vec<String> = steps(rings, ring).map(|i| format!("S{i}")).collect();
        let _ = writeln!(out, "typedef enum {{ {} }} Place_{ring};", all.join(", "));
    }
    out.push_str("\ntypedef struct {\n");
    for ring in 0..rings.tokens {
        let _ = writeln!(out, "    Place_{ring} ring_{ring};");
    }
    out.push_str(
        "    Ring_outputs outputs;\n} Ring;\n\nvoid Ring_init(Ring *chart);\n\
         const Ring_outputs *Ring_scan(Ring *chart, const Ring_inputs *inputs, uint32_t now_ms);\n",
    );
    out
}

fn source(rings: Rings, evolution: Evolution) -> String {
    let mut out = String::from("#include \"chart.h\"\n#include <string.h>\n");
    for ring in 0..rings.tokens {
        write_ring(&mut out, rings, ring);
    }
    out.push_str("\nvoid Ring_init(Ring *chart)\n{\n    memset(chart, 0, sizeof *chart);\n");
    for ring in 0..rings.tokens {
        let first = ring * rings.length();
        let _ = writeln!(out, "    chart->ring_{ring} = S{first};\n    chart->outputs.w_{first} = true;");
    }
    out.push_str("}\n\nconst Ring_outputs *Ring_scan(Ring *chart, const Ring_inputs *inputs, uint32_t now_ms)\n{\n");
    let calls = |before: &str, indent: &str| -> String {
        (0..rings.tokens).map(|ring| format!("{indent}{before}scan_{ring}(chart, inputs);\n")).collect()
    };
    match evolution {
        Evolution::Scan => {
            let _ = write!(out, "    (void)now_ms;\n{}", calls("(void)", "    "));
        }
        Evolution::Stable => {
            let calls = calls("again |= ", "        ");
            let _ = write!(
                out,
                "    bool again;\n\n    (void)now_ms;\n    do {{\n        again = false;\n{calls}    }} while (again);\n"
            );
        }
    }
    out.push_str("    return &chart->outputs;\n}\n");
    out
}

fn write_ring(out: &mut String, rings: Rings, ring: usize) {
    let _ = writeln!(out, "\nstatic bool scan_{ring}(Ring *chart, const Ring_inputs *inputs)\n{{");
    let _ = writeln!(out, "    switch (chart->ring_{ring}) {{");
    let moved = |from: usize, to: usize| {
        format!(
            "            chart->outputs.w_{from} = false;
            chart->outputs.w_{to} = true;
            chart->ring_{ring} = S{to};
            return true;
        }}\n"
        )
    };
    for step in steps(rings, ring) {
        let _ = write!(out, "    case S{step}:\n        if (inputs->x_{step}) {{\n{}", moved(step, rings.next(step)));
        if let Some(aside) = rings.aside(step) {
            let _ = write!(out, "        if (inputs->aside) {{\n{}", moved(step, aside));
        }
        out.push_str("        break;\n");
    }
    out.push_str("    }\n    return false;\n}\n");
}

fn steps(rings: Rings, ring: usize) -> Range<usize> {
    ring * rings.length()..(ring + 1) * rings.length()
}
