//! What a text declares, and where.

use super::parts::Parts;
use crate::chart::VariableId;
use crate::symbols::{Definition, Entity};
use grafc_syntax::ast;

/// All declarations, in order of their entities.
pub fn definitions(tree: &ast::Chart, parts: &Parts) -> Vec<Definition> {
    let mut definitions = Vec::new();
    let mut define = |entity, name, whole| definitions.push(Definition { entity, name, whole });
    if let Some(heading) = &tree.heading {
        define(Entity::Chart, Some(heading.name.span), heading.span);
    }
    let declared = parts.declarations.iter().flat_map(|item| item.names.iter().map(|name| (name, item.span)));
    for (index, (declared, whole)) in declared.enumerate() {
        define(Entity::Variable(VariableId::new(index)), Some(declared.name.span), whole);
    }
    for (id, part) in parts.grafcets.iter_enumerated() {
        let name = part.ast.map(|block| block.name.span);
        define(Entity::Grafcet(id), name, part.ast.map_or(tree.span, |block| block.span));
    }
    for node in parts.nodes() {
        let step = parts.step(node).ast;
        define(node.into(), Some(step.label.span), step.span);
    }
    for (id, part) in parts.transitions.iter_enumerated() {
        let designation = part.ast.designation();
        define(Entity::Transition(id), designation.map(|name| name.span), part.ast.span);
    }
    definitions
}
