//! What names mean: a variable as it is at this place, a step's flag, the output of a block, a named number.

use super::maker::Maker;
use super::resolve::{Cases, Environment, Loss, MOST_CASES, Site};
use super::terms::{TermId, TermKind, VarId};
use grafc_diagnostics::Span;
use grafc_syntax::ast::Type;

/// What a path means.
enum Meaning {
    Term(TermId),
    Variable(VarId),
}

impl Maker<'_> {
    /// A variable as it is at this place, a step's flag, a named number.
    pub(super) fn path(
        &mut self,
        path: &str,
        wanted: Type,
        span: Span,
        site: &Site,
        environment: &Environment,
    ) -> Result<Cases, Loss> {
        let meaning = self.meaning(path, Some(wanted), span, site)?;
        let id = match meaning {
            Meaning::Term(term) => {
                let ty = self.terms.terms[term].ty;
                if ty.is_some_and(|ty| !ty.widens_to(wanted)) {
                    return Err(Loss { why: format!("`{path}` is not of type `{}`", wanted.keyword()), span });
                }
                return Ok(self.certain(term));
            }
            Meaning::Variable(id) => id,
        };
        let ty = self.variables.list[id].ty;
        if !ty.widens_to(wanted) {
            let why = format!("`{path}` is of type `{}`, and `{}` is wanted", ty.keyword(), wanted.keyword());
            return Err(Loss { why, span });
        }
        self.variables.list[id].used.read = true;
        let old = self.terms.add(TermKind::Variable(id), Some(ty), span);
        let Some(cases) = environment.get(&id) else { return Ok(self.certain(old)) };
        let mut cases = cases.clone();
        if let Some(here) = self.here {
            let possible = cases.into_iter().filter_map(|(guard, value)| Some((self.terms.under(guard, here)?, value)));
            cases = possible.collect();
        }
        let guards: Vec<TermId> = cases.iter().map(|(guard, _)| *guard).collect();
        if !guards.iter().any(|&guard| self.terms.is(guard, true)) {
            let any = self.terms.any(guards, span);
            let rest = self.terms.not(any);
            if !self.terms.is(rest, false) {
                cases.push((rest, old));
            }
        }
        if cases.len() > MOST_CASES {
            return Err(Loss { why: "its value depends on too many cases".into(), span });
        }
        if ty == Type::Bool {
            let merged = self.merged(cases);
            return Ok(self.certain(merged));
        }
        Ok(cases)
    }

    /// The variable that is set by a path.
    pub fn target(&mut self, path: &str, ty: Option<Type>, span: Span, site: &Site) -> Result<VarId, Loss> {
        match self.meaning(path, ty, span, site)? {
            Meaning::Variable(id) => Ok(id),
            Meaning::Term(_) => Err(Loss { why: format!("`{path}` is no variable that can be set"), span }),
        }
    }

    fn meaning(&mut self, path: &str, wanted: Option<Type>, span: Span, site: &Site) -> Result<Meaning, Loss> {
        if path.contains('?') || path.contains('^') {
            return Err(Loss {
                why: format!("`{path}`: charts have no pointers, nor arrays whose place is computed"),
                span,
            });
        }
        if let Some(term) = self.flag(path, span, site)? {
            return Ok(Meaning::Term(term));
        }
        if let Some(term) = self.block_output(path, span, site)? {
            return Ok(Meaning::Term(term));
        }
        if let Some(id) = self.variables.find(&format!("{}{path}", site.scope.prefix)) {
            return Ok(Meaning::Variable(id));
        }
        if let Some(found) = self.declared(path, span, site)? {
            return Ok(Meaning::Variable(found));
        }
        let lower = path.to_lowercase();
        if let Some(&number) = self.constants.get(&lower) {
            return Ok(Meaning::Term(self.terms.add(TermKind::Integer(number), None, span)));
        }
        if let Some(id) = self.variables.find(path) {
            return Ok(Meaning::Variable(id));
        }
        let id = self.variables.assumed(path, wanted.unwrap_or(Type::Bool), span);
        Ok(Meaning::Variable(id))
    }

    /// `Step.X` and `Step.T`, in the spellings of several tools.
    fn flag(&mut self, path: &str, span: Span, site: &Site) -> Result<Option<TermId>, Loss> {
        let Some((name, flag)) = path.split_once('.') else { return Ok(None) };
        let flag = flag.trim_start_matches('_').to_ascii_lowercase();
        if !matches!(flag.as_str(), "x" | "t") {
            return Ok(None);
        }
        let unit = self.unit(&site.scope);
        let name = match name.get(..2) {
            Some(head) if self.dialect == crate::Dialect::Isagraf && head.eq_ignore_ascii_case("GS") => {
                if self.step(site.part, name).is_some() { name } else { &name[2..] }
            }
            _ => name,
        };
        let Some(step) = self.step(site.part, name) else { return Ok(None) };
        if unit.variables.find(name).is_some() {
            return Ok(None);
        }
        Ok(Some(match (flag.as_str(), site.own) {
            ("x", Some((own, active))) if own == step => self.terms.constant(active, span),
            ("x", _) => self.terms.logic(TermKind::Active(step), span),
            _ => self.terms.add(TermKind::Time(step), Some(Type::Time), span),
        }))
    }

    /// A variable that the unit or the file declares, or a member of one.
    fn declared(&mut self, path: &str, span: Span, site: &Site) -> Result<Option<VarId>, Loss> {
        let project = self.project;
        let unit = self.unit(&site.scope);
        let global = |name: &str| project.globals.find(name);
        let (first, rest) = path.split_once('.').map_or((path, None), |(first, rest)| (first, Some(rest)));
        let first = first.split('[').next().unwrap_or(first);
        let (variable, rest, key) = if let Some(own) = unit.variables.find(first) {
            (own, rest, format!("{}{path}", site.scope.prefix))
        } else if let Some(own) = global(path) {
            (own, None, path.to_string())
        } else if let Some(own) = global(first) {
            (own, rest, path.to_string())
        } else if let Some((list, inner)) = rest.and_then(|rest| {
            let (name, inner) = rest.split_once('.').map_or((rest, None), |(name, inner)| (name, Some(inner)));
            global(&format!("{first}.{name}")).map(|variable| (variable, inner))
        }) {
            (list, inner, path.to_string())
        } else if let (Some(&other), Some(rest)) = (self.units.get(&first.to_lowercase()), rest) {
            let name = rest.split(['.', '[']).next().unwrap_or(rest);
            match project.units[other].variables.find(name) {
                Some(variable) => (variable, rest.split_once('.').map(|(_, rest)| rest), path.to_string()),
                None => return Ok(None),
            }
        } else {
            return Ok(None);
        };
        if let Some(id) = self.variables.find(&key) {
            return Ok(Some(id));
        }
        let ty = self.member_type(&variable.ty, rest);
        let ty = match self.type_named(&ty) {
            Some(ty) => ty,
            None if ty.is_empty() => return Ok(None),
            None => {
                let why = format!("`{path}` is of the type `{ty}`, which charts do not have");
                return Err(Loss { why, span });
            }
        };
        let id = self.variables.declared(&key, ty, variable);
        if rest.is_some() || path.contains('[') {
            // What is said of the whole is not said of a part.
            let part = &mut self.variables.list[id];
            (part.initial, part.address, part.comment) = (None, None, None);
        }
        Ok(Some(id))
    }
}
