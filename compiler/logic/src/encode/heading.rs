//! The headings that a reader of the program finds its way by.

use crate::scan::{Heading, Statement};

/// Adds statements under a heading, if there are any.
pub(crate) fn heading(out: &mut Vec<Statement>, of: Heading, statements: Vec<Statement>) {
    if !statements.is_empty() {
        out.push(Statement::Heading(of));
        out.extend(statements);
    }
}
