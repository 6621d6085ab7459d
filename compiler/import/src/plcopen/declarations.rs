//! Variables and types.

use super::bodies::Reading;
use super::document::{child, children, name, number};
use super::graph::is_true;
use crate::code::expression;
use crate::code::source::Source;
use crate::sfc::{ByName, Enumeration, Section, Structure, Variable};
use crate::xml::ElementId;

/// The lists of an interface and what they declare.
const LISTS: [(&str, Section); 7] = [
    ("inputVars", Section::Input),
    ("outputVars", Section::Output),
    ("inOutVars", Section::InOut),
    ("localVars", Section::Local),
    ("tempVars", Section::Local),
    ("externalVars", Section::External),
    ("globalVars", Section::Global),
];

impl Reading<'_> {
    /// The variables of an interface.
    pub fn interface(&mut self, interface: ElementId) -> Vec<Variable> {
        let mut found = Vec::new();
        let lists = self.document.elements[interface].children.clone();
        for list in lists {
            let kind = LISTS.iter().find(|(name, _)| *name == self.document.elements[list].name);
            if let Some((_, section)) = kind {
                found.extend(self.list(list, *section));
            }
        }
        found
    }

    /// The variables of a list.
    pub fn list(&mut self, list: ElementId, section: Section) -> Vec<Variable> {
        let element = &self.document.elements[list];
        let constant = is_true(element, "constant");
        let retain = is_true(element, "retain") || is_true(element, "persistent");
        let declared: Vec<ElementId> = children(self.document, list, "variable").collect();
        let variables = declared.into_iter().filter_map(|id| self.variable(id, section));
        variables.map(|variable| Variable { constant, retain, ..variable }).collect()
    }

    fn variable(&mut self, id: ElementId, section: Section) -> Option<Variable> {
        let element = &self.document.elements[id];
        let name = name(element)?.to_string();
        let ty = child(self.document, id, "type").map(|ty| self.type_name(ty)).unwrap_or_default();
        let initial = child(self.document, id, "initialValue")
            .and_then(|value| child(self.document, value, "simpleValue"))
            .and_then(|value| self.document.elements[value].attribute("value"));
        let initial = initial.map(str::trim).filter(|text| !text.is_empty()).map(|text| {
            let mut source = Source::empty(element.span);
            source.text = text.to_string();
            expression(&source, self.code)
        });
        let address = element.attribute("address").map(str::trim).filter(|text| !text.is_empty()).map(str::to_string);
        let comment = self.documentation(id);
        Some(Variable {
            name,
            section,
            ty,
            initial,
            address,
            comment,
            constant: false,
            retain: false,
            span: element.span,
        })
    }

    /// The name of a type; of arrays and texts, what they are.
    fn type_name(&self, ty: ElementId) -> String {
        let Some(&id) = self.document.elements[ty].children.first() else { return String::new() };
        let element = &self.document.elements[id];
        match element.name.as_str() {
            "derived" => name(element).unwrap_or_default().to_string(),
            "array" => child(self.document, id, "baseType").map_or_else(String::new, |base| {
                let Some(&inner) = self.document.elements[base].children.first() else { return String::new() };
                let inner = &self.document.elements[inner];
                let base = if inner.name == "derived" { name(inner).unwrap_or_default() } else { &inner.name };
                format!("ARRAY OF {base}")
            }),
            other => other.to_ascii_uppercase(),
        }
    }

    /// A type of its own.
    pub fn data_type(
        &mut self,
        id: ElementId,
        enumerations: &mut ByName<Enumeration>,
        structures: &mut ByName<Structure>,
    ) {
        let Some(name) = name(&self.document.elements[id]).map(str::to_string) else { return };
        let Some(base) = child(self.document, id, "baseType") else { return };
        let Some(&inner) = self.document.elements[base].children.first() else { return };
        match self.document.elements[inner].name.as_str() {
            "enum" => {
                let Some(list) = child(self.document, inner, "values") else { return };
                let mut next = 0_i64;
                let mut values = Vec::new();
                for value in children(self.document, list, "value") {
                    let element = &self.document.elements[value];
                    let number: i64 = number(element, "value").unwrap_or(next);
                    next = number.saturating_add(1);
                    values.extend(super::document::name(element).map(|name| (name.to_string(), number)));
                }
                enumerations.push(Enumeration { name, values });
            }
            "struct" => {
                let declared: Vec<ElementId> = children(self.document, inner, "variable").collect();
                let members = declared.into_iter().filter_map(|id| self.variable(id, Section::Local)).collect();
                structures.push(Structure { name, members });
            }
            _ => {}
        }
    }
}
