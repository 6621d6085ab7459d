//! The variables of a program organisation unit.

use super::dialect::Dialect;
use crate::iec::declarations::{Entry, EntryType, VarBlock, VarKind};
use crate::xml::Xml;

/// Writes the interface: a list a block, in the order of the blocks.
pub(super) fn write(xml: &mut Xml, blocks: &[VarBlock], dialect: Dialect) {
    xml.open("interface", &[]);
    for block in blocks.iter().filter(|block| block.entries().next().is_some()) {
        match block.kind {
            VarKind::Input => xml.open("inputVars", &[]),
            VarKind::Output => xml.open("outputVars", &[]),
            VarKind::Constant => xml.open("localVars", &[("constant", "true")]),
            VarKind::Local => xml.open("localVars", &[]),
        }
        for entry in block.entries() {
            variable(xml, entry, dialect);
        }
        xml.close();
    }
    xml.close();
}

fn variable(xml: &mut Xml, entry: &Entry, dialect: Dialect) {
    match &entry.address {
        Some(address) => xml.open("variable", &[("name", &entry.name), ("address", address)]),
        None => xml.open("variable", &[("name", &entry.name)]),
    }
    xml.open("type", &[]);
    match &entry.ty {
        EntryType::Elementary(ty) => xml.empty(crate::iec::literals::type_name(*ty), &[]),
        EntryType::Timer | EntryType::Block(_) => xml.empty("derived", &[("name", entry.ty.name())]),
    }
    xml.close();
    if let Some(initial) = &entry.initial {
        xml.open("initialValue", &[]);
        xml.empty("simpleValue", &[("value", initial)]);
        xml.close();
    }
    if let Some(comment) = &entry.comment {
        dialect.documentation(xml, comment);
    }
    xml.close();
}
