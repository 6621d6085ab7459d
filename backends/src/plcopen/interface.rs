//! The variables of a program organisation unit.

use super::dialect::Dialect;
use crate::iec::declarations::{Entry, EntryType, VarBlock, VarKind};
use crate::xml::Xml;

/// Writes the interface: a list a block, in the order of the blocks.
pub(super) fn write(xml: &mut Xml, blocks: &[VarBlock], dialect: Dialect) {
    xml.open("interface", &[]);
    for list in blocks.iter().flat_map(VarBlock::lists) {
        let (element, constant) = match list.kind {
            VarKind::Input => ("inputVars", None),
            VarKind::Output => ("outputVars", None),
            VarKind::Constant => ("localVars", Some(("constant", "true"))),
            VarKind::Local => ("localVars", None),
            VarKind::Temporary => ("tempVars", None),
        };
        let retain = list.retain.then_some(("retain", "true"));
        xml.open(element, &constant.into_iter().chain(retain).collect::<Vec<_>>());
        for entry in list.entries() {
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
