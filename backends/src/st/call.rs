//! The statements of the program around the function block.

use crate::writer::Writer;

/// Calls the instance, inputs by name, and copies out what is published.
pub(crate) fn write(out: &mut Writer, instance: &str, inputs: &[&str], published: &[&str]) {
    let arguments: Vec<String> = inputs.iter().map(|name| format!("{name} := {name}")).collect();
    let flat = format!("{instance}({});", arguments.join(", "));
    if flat.len() <= out.width() {
        out.line(&flat);
    } else {
        out.open(&format!("{instance}("));
        for (place, argument) in arguments.iter().enumerate() {
            out.line(&format!("{argument}{}", if place + 1 < arguments.len() { "," } else { "" }));
        }
        out.close(");");
    }
    for name in published {
        out.line(&format!("{name} := {instance}.{name};"));
    }
}
