//! IEC 61131-10:2019: the function block in the exchange format that Omron, Mitsubishi and Phoenix Contact read.
//!
//! It is the successor of PLCopen XML, but another language: other elements, texts without XHTML, parameters counted
//! through inputs and outputs together. Only the function block is written; some readers refuse or ignore the rest.
//! Within a variable the comment comes first, then the type, then the initial value.

pub(crate) mod target;

use crate::comment::clean;
use crate::iec::declarations::{Entry, VarBlock, VarKind, VarList};
use crate::st::{self, Style};
use crate::xml::Xml;
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::Program;

/// What the caller may choose.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// Which chart, which version, which options.
    pub header: Vec<String>,
}

/// Writes a program as a function block.
///
/// An error is a fault of grafc: the program breaks a promise of [`Program`] or is too deeply nested to be written.
pub fn emit(program: &Program, options: &Options) -> Result<String, Diagnostics> {
    let parts = st::parts(program, Style::default())?;
    let mut xml = Xml::new();
    xml.open(
        "Project",
        &[
            ("xmlns", "www.iec.ch/public/TC65SC65BWG7TF10"),
            ("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"),
            ("schemaVersion", "1.0"),
        ],
    );
    let version = env!("CARGO_PKG_VERSION");
    xml.empty("FileHeader", &[("companyName", "grafc"), ("productName", "grafc"), ("productVersion", version)]);
    xml.empty("ContentHeader", &[("name", &parts.block), ("creationDateTime", "2000-01-01T00:00:00")]);
    xml.open("Types", &[]);
    xml.open("GlobalNamespace", &[]);
    xml.open("FunctionBlock", &[("name", &parts.block)]);
    let mut description: Vec<String> = options.header.iter().map(|line| clean(line)).collect();
    description.extend(parts.description);
    documentation(&mut xml, &description.join("\n"));
    interface(&mut xml, &parts.interface);
    xml.open("MainBody", &[]);
    xml.open("BodyContent", &[("xsi:type", "ST")]);
    xml.text("ST", &[], &parts.body);
    for _ in ["BodyContent", "MainBody", "FunctionBlock", "GlobalNamespace", "Types"] {
        xml.close();
    }
    xml.empty("Instances", &[]);
    Ok(xml.finish())
}

fn interface(xml: &mut Xml, blocks: &[VarBlock]) {
    let lists = |kinds: [VarKind; 2]| {
        let of = move |kind| blocks.iter().filter(move |block| block.kind == kind).flat_map(VarBlock::lists);
        kinds.into_iter().flat_map(of)
    };
    let retain = |list: &VarList| list.retain.then_some(("retain", "true"));
    let mut parameters = 0;
    xml.open("Parameters", &[]);
    for list in lists([VarKind::Input, VarKind::Output]) {
        let element = if list.kind == VarKind::Input { "InputVars" } else { "OutputVars" };
        xml.open(element, &retain(&list).into_iter().collect::<Vec<_>>());
        for entry in list.entries() {
            variable(xml, entry, Some(parameters));
            parameters += 1;
        }
        xml.close();
    }
    xml.close();
    for list in lists([VarKind::Constant, VarKind::Local]) {
        let mut attributes = vec![("accessSpecifier", "private")];
        attributes.extend((list.kind == VarKind::Constant).then_some(("constant", "true")));
        attributes.extend(retain(&list));
        xml.open("Vars", &attributes);
        for entry in list.entries() {
            variable(xml, entry, None);
        }
        xml.close();
    }
}

fn variable(xml: &mut Xml, entry: &Entry, parameter: Option<usize>) {
    match parameter {
        Some(place) => {
            xml.open("Variable", &[("name", &entry.name), ("orderWithinParamSet", &place.to_string())]);
        }
        None => xml.open("Variable", &[("name", &entry.name)]),
    }
    documentation(xml, entry.comment.as_deref().unwrap_or_default());
    xml.open("Type", &[]);
    xml.text("TypeName", &[], entry.ty.name());
    xml.close();
    if let Some(initial) = &entry.initial {
        xml.open("InitialValue", &[]);
        xml.empty("SimpleValue", &[("value", initial)]);
        xml.close();
    }
    xml.close();
}

fn documentation(xml: &mut Xml, text: &str) {
    if !text.is_empty() {
        xml.text("Documentation", &[("xsi:type", "SimpleText")], text);
    }
}
