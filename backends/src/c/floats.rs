//! What real numbers need of a compiler: those of the chart have 32 and 64 bits, and each operation is rounded by itself.
//! Where that is not so the source does not compile; it would compute something else, and nobody would be told.

use crate::writer::Writer;
use grafc_formula::Type;
use grafc_logic::scan::Program;

/// Writes what asks for it, if the program has real numbers.
pub(super) fn write(out: &mut Writer, program: &Program) {
    let has = |ty: Type| {
        program.variables.iter().any(|variable| variable.ty == ty)
            || program.pool.ids().any(|id| program.pool.ty(id) == ty)
    };
    let sizes = [
        (Type::Real, "FLT_MANT_DIG != 24", "a real of the chart is a float of 32 bits"),
        (
            Type::Lreal,
            "DBL_MANT_DIG != 53",
            "an lreal of the chart is a double of 64 bits: make it a real, or give avr-gcc from 10 on -mdouble=64",
        ),
    ];
    let needed: Vec<_> = sizes.into_iter().filter(|(ty, ..)| has(*ty)).collect();
    if needed.is_empty() {
        return;
    }
    out.blank();
    out.line("#include <float.h>");
    for (_, is_other, said) in needed {
        refused(out, is_other, said);
    }
    // 16 rounds to what is not narrower than the types of the chart.
    refused(
        out,
        "FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16",
        "each result is rounded to its own type: on x86 -msse2 -mfpmath=sse",
    );
    out.blank();
    out.comment("a product and a sum are two operations");
    out.line("#if defined(__clang__) || !defined(__GNUC__)");
    out.line("#pragma STDC FP_CONTRACT OFF");
    out.line("#elif defined(__FP_FAST_FMA) || defined(__FP_FAST_FMAF)");
    out.line("#pragma GCC optimize(\"fp-contract=off\")");
    out.line("#endif");
}

fn refused(out: &mut Writer, condition: &str, said: &str) {
    out.line(&format!("#if {condition}"));
    out.line(&format!("#error \"{said}\""));
    out.line("#endif");
}
