//! The rings as an engineer would write them in Rust: an enum a ring says which step is active, and a `match` has an
//! arm a step, in which a transition moves the enum and two outputs.
//!
//! Names and the signature of a scan are those of generated code, so that one program times both. The outputs of the
//! initial steps are set from the start. Each ring has a function that says whether a transition cleared, and the
//! evolution to stability calls them until none has. That this is not inlined makes it faster: with the `match` in the
//! loop, rustc would read all inputs before it, as many as there are steps.

use crate::rings::Rings;
use grafc_model::reaction::Evolution;
use std::fmt::Write as _;

/// One crate.
pub(super) fn write(rings: Rings, evolution: Evolution) -> String {
    let mut out = String::from("#[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct Inputs {\n");
    for i in 0..rings.steps {
        let _ = writeln!(out, "    pub x_{i}: bool,");
    }
    if rings.walked < rings.length() {
        out.push_str("    pub aside: bool,\n");
    }
    out.push_str("}\n\n#[derive(Clone, Copy, Debug, PartialEq)]\npub struct Outputs {\n");
    for i in 0..rings.steps {
        let _ = writeln!(out, "    pub w_{i}: bool,");
    }
    out.push_str("}\n\n");
    for ring in 0..rings.tokens {
        let _ = writeln!(out, "#[derive(Clone, Copy, Debug, PartialEq)]\nenum Ring{ring} {{");
        for i in steps(rings, ring) {
            let _ = writeln!(out, "    S{i},");
        }
        out.push_str("}\n\n");
    }
    out.push_str("#[derive(Clone, Debug, PartialEq)]\npub struct Ring {\n");
    for ring in 0..rings.tokens {
        let _ = writeln!(out, "    ring_{ring}: Ring{ring},");
    }
    out.push_str("    outputs: Outputs,\n}\n\nimpl Ring {\n    pub const fn new() -> Self {\n        Self {\n");
    for ring in 0..rings.tokens {
        let _ = writeln!(out, "            ring_{ring}: Ring{ring}::S{},", ring * rings.length());
    }
    out.push_str("            outputs: Outputs {\n");
    for i in 0..rings.steps {
        let _ = writeln!(out, "                w_{i}: {},", rings.is_initial(i));
    }
    out.push_str("            },\n        }\n    }\n\n    pub const fn outputs(&self) -> &Outputs {\n");
    out.push_str("        &self.outputs\n    }\n\n");
    write_scan(&mut out, rings, evolution);
    for ring in 0..rings.tokens {
        write_ring(&mut out, rings, ring);
    }
    out.push_str("}\n");
    out
}

fn write_scan(out: &mut String, rings: Rings, evolution: Evolution) {
    out.push_str("    pub fn scan(&mut self, inputs: &Inputs, _now: u32) -> &Outputs {\n");
    let calls = |before: &str| -> String {
        (0..rings.tokens).map(|ring| format!("        {before}self.scan_{ring}(inputs);\n")).collect()
    };
    let end = "        &self.outputs\n    }\n";
    match evolution {
        Evolution::Scan => {
            out.push_str(&calls(""));
            out.push_str(end);
        }
        Evolution::Stable => {
            let _ = writeln!(out, "        while self.micro_step(inputs) {{}}\n{end}\n    #[inline(never)]");
            out.push_str("    fn micro_step(&mut self, inputs: &Inputs) -> bool {\n        let mut again = false;\n");
            out.push_str(&calls("again |= "));
            out.push_str("        again\n    }\n");
        }
    }
}

fn write_ring(out: &mut String, rings: Rings, ring: usize) {
    let _ = writeln!(out, "\n    fn scan_{ring}(&mut self, inputs: &Inputs) -> bool {{");
    let _ = writeln!(out, "        match self.ring_{ring} {{");
    let moved = |from: usize, to: usize| {
        format!(
            "                    self.outputs.w_{from} = false;
                    self.outputs.w_{to} = true;
                    self.ring_{ring} = Ring{ring}::S{to};
                    return true;
                }}"
        )
    };
    for step in steps(rings, ring) {
        let body = moved(step, rings.next(step));
        let _ = write!(out, "            Ring{ring}::S{step} => {{\n                if inputs.x_{step} {{\n{body}\n");
        if let Some(aside) = rings.aside(step) {
            let _ = writeln!(out, "                if inputs.aside {{\n{}", moved(step, aside));
        }
        out.push_str("            }\n");
    }
    out.push_str("        }\n        false\n    }\n");
}

fn steps(rings: Rings, ring: usize) -> std::ops::Range<usize> {
    ring * rings.length()..(ring + 1) * rings.length()
}
