//! The frame of a project: headers, the two program organisation units, what runs them.

use super::Options;
use super::dialect::{Dialect, XHTML};
use super::interface;
use crate::comment::clean;
use crate::iec::declarations::VarBlock;
use crate::iec::pou_parts::PouParts;
use crate::xml::Xml;

/// The schema demands dates; the same chart gives the same file on every day.
const NO_DATE: &str = "2000-01-01T00:00:00";

/// Writes a whole project. The function block has actions, with their statements; `body` writes what its body holds.
pub(super) fn write(
    parts: &PouParts,
    options: &Options,
    actions: &[(String, String)],
    body: impl FnOnce(&mut Xml, Dialect),
) -> String {
    write_with(parts, options, |_| (), actions, body)
}

/// Writes a whole project with further units before the function block, which it needs.
pub(super) fn write_with(
    parts: &PouParts,
    options: &Options,
    needed: impl FnOnce(&mut Xml),
    actions: &[(String, String)],
    body: impl FnOnce(&mut Xml, Dialect),
) -> String {
    let dialect = options.dialect;
    let mut xml = Xml::new();
    match dialect {
        Dialect::Neutral => xml.open("project", &[("xmlns", dialect.namespace()), ("xmlns:xhtml", XHTML)]),
        Dialect::Codesys => xml.open("project", &[("xmlns", dialect.namespace())]),
    }
    headers(&mut xml, parts, options);

    xml.open("types", &[]);
    xml.empty("dataTypes", &[]);
    xml.open("pous", &[]);
    needed(&mut xml);
    xml.open("pou", &[("name", &parts.block), ("pouType", "functionBlock")]);
    unit(&mut xml, &parts.interface, actions, parts.description.as_deref(), dialect, body);
    xml.open("pou", &[("name", &parts.program), ("pouType", "program")]);
    let call = |xml: &mut Xml, dialect: Dialect| dialect.body(xml, parts.language.name(), &parts.program_body);
    unit(&mut xml, &parts.program_variables, &[], None, dialect, call);
    xml.close();
    xml.close();

    instances(&mut xml, parts, options);
    xml.finish()
}

fn headers(xml: &mut Xml, parts: &PouParts, options: &Options) {
    xml.empty(
        "fileHeader",
        &[
            ("companyName", "grafc"),
            ("productName", "grafc"),
            ("productVersion", env!("CARGO_PKG_VERSION")),
            ("creationDateTime", NO_DATE),
        ],
    );
    xml.open("contentHeader", &[("name", &parts.block), ("modificationDateTime", NO_DATE)]);
    if !options.header.is_empty() {
        let lines: Vec<String> = options.header.iter().map(|line| clean(line)).collect();
        xml.text("Comment", &[], &lines.join("\n"));
    }
    xml.open("coordinateInfo", &[]);
    for language in ["fbd", "ld", "sfc"] {
        xml.open(language, &[]);
        xml.empty("scaling", &[("x", "1"), ("y", "1")]);
        xml.close();
    }
    xml.close();
    xml.close();
}

/// What an open unit holds, and its end.
pub(super) fn unit(
    xml: &mut Xml,
    variables: &[VarBlock],
    actions: &[(String, String)],
    description: Option<&str>,
    dialect: Dialect,
    body: impl FnOnce(&mut Xml, Dialect),
) {
    interface::write(xml, variables, dialect);
    if !actions.is_empty() {
        xml.open("actions", &[]);
        for (name, statements) in actions {
            xml.open("action", &[("name", name)]);
            xml.open("body", &[]);
            dialect.body(xml, "ST", statements);
            xml.close();
            xml.close();
        }
        xml.close();
    }
    xml.open("body", &[]);
    body(xml, dialect);
    xml.close();
    if let Some(description) = description {
        dialect.documentation(xml, description);
    }
    xml.close();
}

/// The configuration with its task, if there is one.
fn instances(xml: &mut Xml, parts: &PouParts, options: &Options) {
    let dialect = options.dialect;
    xml.open("instances", &[]);
    let Some(ms) = dialect.interval(options.interval_ms) else {
        xml.empty("configurations", &[]);
        return xml.close();
    };
    xml.open("configurations", &[]);
    xml.open("configuration", &[("name", &parts.configuration)]);
    xml.open("resource", &[("name", &parts.resource)]);
    xml.open("task", &[("name", &parts.task), ("priority", "0"), ("interval", &dialect.duration(ms))]);
    let instance = [("name", parts.program_instance.as_str()), ("typeName", parts.program.as_str())];
    match dialect {
        Dialect::Neutral => xml.empty("pouInstance", &instance),
        // TwinCAT does not take an instance without one.
        Dialect::Codesys => {
            xml.open("pouInstance", &instance);
            dialect.documentation(xml, "");
            xml.close();
        }
    }
    for _ in ["task", "resource", "configuration", "configurations", "instances"] {
        xml.close();
    }
}
