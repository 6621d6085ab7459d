//! Types of members, of expressions as far as their form tells, and of what conversions are given.

use super::maker::Maker;
use super::resolve::{Loss, Site};
use super::variables::elementary;
use crate::code::tree::{Argument, ExprId, ExprKind};
use grafc_diagnostics::Span;
use grafc_syntax::ast::Type;

/// How many parts of a comparison are looked at for a type.
const PARTS: usize = 64;

impl Maker<'_> {
    /// The type of a member of something, as far as types of the file tell; an empty one if they do not.
    pub(super) fn member_type(&self, ty: &str, rest: Option<&str>) -> String {
        let project = self.project;
        let element = |ty: &str| ty.strip_prefix("ARRAY OF ").unwrap_or(ty).to_string();
        let mut ty = element(ty);
        for segment in rest.into_iter().flat_map(|rest| rest.split('.')) {
            let name = segment.split('[').next().unwrap_or(segment);
            let structure = project.structures.find(&ty).map(|s| &s.members);
            let unit = self.units.get(&ty.to_lowercase()).map(|&unit| &project.units[unit].variables);
            let member = structure.or(unit).and_then(|list| list.find(name));
            let Some(member) = member else { return String::new() };
            ty = element(&member.ty);
        }
        ty
    }

    /// The type of what one of two operands certainly is.
    pub(super) fn type_of_either(&self, a: ExprId, b: ExprId, site: &Site) -> Option<Type> {
        let code = &self.project.code;
        let mut stack = vec![b, a];
        let mut found: Option<Type> = None;
        for _ in 0..PARTS {
            let Some(id) = stack.pop() else { break };
            let ty = match &code.exprs[id].kind {
                ExprKind::Bool(_) | ExprKind::Not(_) | ExprKind::Edge(..) => Some(Type::Bool),
                ExprKind::Binary(operator, ..) if operator.is_logic() || operator.compares() => Some(Type::Bool),
                ExprKind::Real(_) => Some(Type::Lreal),
                ExprKind::Duration(_) => Some(Type::Time),
                ExprKind::Path(path) => self.type_of_path(path, site),
                ExprKind::Call(name, _) if name.eq_ignore_ascii_case("GSTATUS") => Some(Type::Int),
                ExprKind::Call(name, _) => {
                    name.rsplit_once("_TO_").or(name.rsplit_once("_to_")).and_then(|(_, to)| elementary(to))
                }
                ExprKind::Integer(_) | ExprKind::Unknown(_) => None,
                ExprKind::Negate(_) | ExprKind::Binary(..) => {
                    stack.extend(code.operands(id).into_iter().rev());
                    None
                }
            };
            found = match (found, ty) {
                (Some(before), Some(ty)) if before.widens_to(ty) => Some(ty),
                (Some(before), _) => Some(before),
                (None, ty) => ty,
            };
        }
        // A literal with a fraction takes the type of what it meets.
        found
    }

    /// The type of a value by its form, if that tells.
    pub fn type_of_value(&self, id: ExprId, site: &Site) -> Option<Type> {
        self.type_of_either(id, id, site)
    }

    /// The type of what a `CASE` chooses by.
    pub fn type_of_selector(&self, id: ExprId, site: &Site) -> Type {
        self.type_of_value(id, site).filter(|ty| ty.is_whole()).unwrap_or(Type::Dint)
    }

    fn type_of_path(&self, path: &str, site: &Site) -> Option<Type> {
        let known = self.variables.find(&format!("{}{path}", site.scope.prefix)).or_else(|| self.variables.find(path));
        if let Some(id) = known {
            return Some(self.variables.list[id].ty);
        }
        let (first, rest) = path.split_once('.').map_or((path, None), |(first, rest)| (first, Some(rest)));
        if let Some(rest) = rest
            && self.step(site.part, first).is_some()
        {
            return match rest.trim_start_matches('_').to_ascii_lowercase().as_str() {
                "x" => Some(Type::Bool),
                "t" => Some(Type::Time),
                _ => None,
            };
        }
        let first = first.split('[').next().unwrap_or(first);
        let unit = self.unit(&site.scope);
        let globals = &self.project.globals;
        let variable = unit
            .variables
            .find(first)
            .map(|variable| (variable, rest))
            .or_else(|| globals.find(path).map(|variable| (variable, None)))
            .or_else(|| globals.find(first).map(|variable| (variable, rest)));
        let (variable, rest) = variable?;
        self.type_named(&self.member_type(&variable.ty, rest))
    }

    /// A type by its name; enumerations are numbers.
    pub(super) fn type_named(&self, name: &str) -> Option<Type> {
        let is_enumeration = || self.project.enumerations.find(name).is_some();
        elementary(name).or_else(|| is_enumeration().then_some(Type::Int))
    }

    /// The operand of a conversion that loses nothing, with the type that it has.
    pub(super) fn conversion(
        &self,
        name: &str,
        arguments: &[Argument],
        wanted: Type,
        span: Span,
    ) -> Result<(ExprId, Type), Loss> {
        let upper = name.to_ascii_uppercase();
        let from_to = upper.split_once("_TO_").map(|(from, to)| (elementary(from), elementary(to)));
        let [argument] = arguments else {
            return Err(Loss { why: format!("charts do not have the function `{name}`"), span });
        };
        match from_to {
            Some((Some(from), Some(to))) if from.widens_to(to) && to.widens_to(wanted) => Ok((argument.value, from)),
            // A literal is of any type that holds it.
            Some((Some(from), Some(to)))
                if to.is_whole()
                    && from.is_whole()
                    && wanted.is_whole()
                    && matches!(self.project.code.exprs[argument.value].kind, ExprKind::Integer(_)) =>
            {
                Ok((argument.value, wanted))
            }
            Some(_) => Err(Loss { why: format!("charts do not convert as `{name}` does"), span }),
            None => Err(Loss { why: format!("charts do not have the function `{name}`"), span }),
        }
    }
}
