//! Instructions line by line: labels at the margin, then operators, operands, comments.

use crate::comment::clean;
use crate::writer::Writer;
use ecow::EcoString;
use grafc_formula::FormulaId;

/// Where comments beside instructions begin, if the instruction is shorter.
const REMARKS: usize = 32;

/// What the accumulator holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Known {
    /// A truth value.
    Truth(bool),
    /// A constant that is no truth value.
    Constant(FormulaId),
}

/// The instructions of a body, written so far.
pub(super) struct Code {
    /// The text.
    pub out: Writer,
    /// How many instructions there are.
    pub count: u64,
    /// Names of the variables that hold parts of formulas.
    pub parts: Vec<EcoString>,
    /// What is known of the accumulator.
    pub known: Option<Known>,
    /// What the reader should know, due beside the next instruction.
    remark: Option<String>,
    /// Within a parenthesis.
    inside: bool,
}

impl Code {
    /// No instructions yet.
    pub fn new(out: Writer) -> Self {
        Code { out, count: 0, parts: Vec::new(), known: None, remark: None, inside: false }
    }

    /// Something to stand beside the next instruction.
    pub fn remark(&mut self, text: Option<&str>) {
        self.remark = text.map(clean).filter(|text| !text.is_empty());
    }

    /// A heading for what follows.
    pub fn heading(&mut self, text: &str) {
        self.out.blank();
        self.out.comment(&clean(text));
    }

    /// An instruction that leaves the accumulator as it is.
    pub fn instruction(&mut self, operator: &str, operand: &str) {
        self.count += 1;
        let indent = if self.inside { "      " } else { "    " };
        let text = format!("{indent}{operator:<6}{operand}");
        let text = text.trim_end();
        let length = text.chars().count();
        let remark = self.remark.take();
        let behind = remark.as_deref().filter(|remark| self.out.fits_behind(length.max(REMARKS), remark));
        if behind.is_none() {
            self.out.comment(remark.as_deref().unwrap_or_default());
        }
        self.out.start();
        self.out.text(text);
        if let Some(remark) = behind {
            self.out.trailing_comment(length, REMARKS, remark);
        }
        self.out.end();
    }

    /// An instruction that gives the accumulator another value.
    pub fn operation(&mut self, operator: &str, operand: &str) {
        self.instruction(operator, operand);
        self.known = None;
    }

    /// An operation on what follows up to [`Code::close`], which begins with a value.
    pub fn open(&mut self, operator: &str, operand: &str) {
        self.operation(&format!("{operator}("), operand);
        self.inside = true;
    }

    /// Ends the parenthesis.
    pub fn close(&mut self) {
        self.instruction(")", "");
        self.inside = false;
    }

    /// Jumps where the accumulator is true.
    pub fn jump_if(&mut self, label: &str) {
        self.instruction("JMPC", label);
        self.known = Some(Known::Truth(false));
    }

    /// Jumps where the accumulator is false.
    pub fn jump_unless(&mut self, label: &str) {
        self.instruction("JMPCN", label);
        self.known = Some(Known::Truth(true));
    }

    /// Where a jump leads.
    pub fn label(&mut self, label: &str) {
        self.out.line(&format!("{label}:"));
        self.known = None;
    }
}
