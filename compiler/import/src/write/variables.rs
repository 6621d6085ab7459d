//! The variables of a chart: found under the names by which the file calls them, and what is done with them.

use super::terms::VarId;
use crate::code::tree::ExprId;
use crate::sfc::{Section, Variable};
use grafc_diagnostics::Span;
use grafc_syntax::ast::Type;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// A variable.
pub struct Var {
    /// By which the file calls it, with what stands before it.
    pub path: String,
    pub ty: Type,
    /// Where it is declared; none if nobody declares it.
    pub section: Option<Section>,
    pub initial: Option<ExprId>,
    pub address: Option<String>,
    pub comment: Option<String>,
    pub constant: bool,
    pub retain: bool,
    pub span: Span,
    pub used: VarUse,
}

/// What is done with a variable.
#[derive(Clone, Copy, Default)]
pub struct VarUse {
    pub read: bool,
    /// By the name of an action.
    pub by_name: bool,
    /// By statements, or by actions that store.
    pub stored: bool,
    /// As the time of a delay.
    pub delays: bool,
    /// Made by the import.
    pub helper: bool,
}

/// All variables, by their paths.
#[derive(Default)]
pub struct Variables {
    pub list: IndexVec<VarId, Var>,
    by_path: FxHashMap<String, VarId>,
}

impl Variables {
    /// The variable of a path, in any case.
    pub fn find(&self, path: &str) -> Option<VarId> {
        self.by_path.get(&path.to_lowercase()).copied()
    }

    /// Adds a variable of a declaration under a path.
    pub fn declared(&mut self, path: &str, ty: Type, variable: &Variable) -> VarId {
        self.add(Var {
            path: path.to_string(),
            ty,
            section: Some(variable.section),
            initial: variable.initial,
            address: variable.address.clone(),
            comment: variable.comment.clone(),
            constant: variable.constant,
            retain: variable.retain,
            span: variable.span,
            used: VarUse::default(),
        })
    }

    /// Adds a variable that nobody declares.
    pub fn assumed(&mut self, path: &str, ty: Type, span: Span) -> VarId {
        self.add(Var {
            path: path.to_string(),
            ty,
            section: None,
            initial: None,
            address: None,
            comment: None,
            constant: false,
            retain: false,
            span,
            used: VarUse::default(),
        })
    }

    /// Adds a variable that the import needs.
    pub fn helper(&mut self, path: &str, ty: Type, span: Span) -> VarId {
        if let Some(id) = self.find(path) {
            return id;
        }
        let id = self.assumed(path, ty, span);
        self.list[id].used.helper = true;
        id
    }

    fn add(&mut self, variable: Var) -> VarId {
        let path = variable.path.to_lowercase();
        let id = self.list.push(variable);
        self.by_path.insert(path, id);
        id
    }
}

/// The type of a declaration; none if charts do not have it.
pub fn elementary(ty: &str) -> Option<Type> {
    Some(match ty.to_ascii_uppercase().as_str() {
        "BOOL" | "SAFEBOOL" | "BIT" => Type::Bool,
        "SINT" | "INT" => Type::Int,
        "USINT" | "UINT" | "BYTE" | "WORD" => Type::Uint,
        "DINT" | "LINT" => Type::Dint,
        "UDINT" | "DWORD" | "ULINT" | "LWORD" => Type::Udint,
        "REAL" => Type::Real,
        "LREAL" => Type::Lreal,
        "TIME" | "LTIME" => Type::Time,
        _ => return None,
    })
}
