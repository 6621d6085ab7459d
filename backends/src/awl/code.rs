//! Instructions line by line: a label, an operator, an operand, and what the reader should know.

use super::{AwlNames, Known, Local, Mnemonics, local};
use crate::comment::clean;
use crate::writer::{self, Writer};
use ecow::EcoString;
use grafc_formula::Type;
use rustc_hash::FxHashSet;

/// Where comments beside instructions begin, if the instruction is shorter.
const REMARKS: usize = 40;
/// A title of a network has no more characters.
const LONGEST_TITLE: usize = 64;
/// So many labels begin with one letter, on average.
const LABELS_A_LETTER: u32 = 1000;
/// What follows the letter: without vowels no label is a word.
const SIGNS: &[u8; 30] = b"0123456789BCDFGHJKLMNPQRSTVWXZ";
/// What labels begin with, in this order: letters that no address begins with, except the first, which is the custom.
/// What comes after the last letter does not fit into a block.
const LETTERS: &[u8; 13] = b"MNJKWXYHGVROS";

/// The instructions of a block, written so far.
pub(super) struct Code {
    /// The words.
    mnemonics: Mnemonics,
    /// The text.
    pub out: Writer,
    /// How many instructions there are.
    pub count: u64,
    /// Variables of ours that hold parts of formulas.
    pub parts: Vec<Local>,
    /// The result of logic operation, if it is known and the next instruction on bits begins a new chain.
    pub rlo: Option<bool>,
    /// What is known to be in the accumulator.
    pub known: Known,
    /// What the reader should know, due beside the next instruction.
    remark: Option<String>,
    /// A label that is due before the next instruction.
    label: Option<String>,
    labels: FxHashSet<u64>,
    /// A number that stands for what is written now, from which labels are made.
    about: u64,
    /// Open parentheses.
    depth: usize,
}

impl Code {
    /// No instructions yet.
    pub fn new(mnemonics: Mnemonics, traced: bool) -> Self {
        Code {
            mnemonics,
            out: Writer::new(&writer::STL).traced(traced),
            count: 0,
            parts: Vec::new(),
            rlo: None,
            known: None,
            remark: None,
            label: None,
            labels: FxHashSet::default(),
            about: 0,
            depth: 0,
        }
    }

    /// Something to stand beside the next instruction.
    pub fn remark(&mut self, text: Option<&str>) {
        self.remark = text.map(clean).filter(|text| !text.is_empty());
    }

    /// A network for what follows.
    pub fn network(&mut self, title: &str) {
        let title: String = clean(title).chars().take(LONGEST_TITLE).collect();
        self.out.blank();
        self.out.line("NETWORK");
        self.out.line(&format!("TITLE ={}", title.trim_end()));
    }

    /// A heading within a network.
    pub fn heading(&mut self, text: &str) {
        self.out.comment(&clean(text));
    }

    /// An instruction that leaves result and accumulator as they are. Operators are given in English.
    pub fn instruction(&mut self, operator: &str, operand: &str) {
        self.count += 1;
        let operator = self.mnemonics.operator(operator);
        let label = self.label.take().map_or(String::new(), |label| format!("{label}:"));
        let indent = "  ".repeat(self.depth);
        let text = format!("{label:<6}{indent}{operator:<6}{operand}");
        let text = format!("{};", text.trim_end());
        let length = text.chars().count();
        let remark = self.remark.take();
        let behind = remark.as_deref().filter(|remark| self.out.fits_behind(length.max(REMARKS), remark));
        if behind.is_none() {
            self.out.comment(remark.as_deref().unwrap_or_default());
        }
        self.out.start();
        self.out.text(&text);
        if let Some(remark) = behind {
            self.out.trailing_comment(length, REMARKS, remark);
        }
        self.out.end();
    }

    /// An instruction that gives the result of logic operation another value.
    pub fn bit(&mut self, operator: &str, operand: &str) {
        self.instruction(operator, operand);
        self.rlo = None;
    }

    /// An instruction that gives the accumulator another value.
    pub fn number(&mut self, operator: &str, operand: &str) {
        self.instruction(operator, operand);
        self.known = None;
    }

    /// A comparison: both accumulators are left alone, the result of logic operation is what it finds.
    pub fn comparison(&mut self, operator: &str) {
        self.bit(operator, "");
    }

    /// `SET` or `CLR`, if need be.
    pub fn truth(&mut self, value: bool) {
        if self.rlo != Some(value) {
            self.instruction(if value { "SET" } else { "CLR" }, "");
            self.rlo = Some(value);
        }
    }

    /// Stores the result of logic operation.
    pub fn assign(&mut self, operand: &str) {
        self.instruction("=", operand);
    }

    /// An operation on what follows up to [`Code::close`].
    pub fn open(&mut self, operator: &str) {
        self.bit(&format!("{operator}("), "");
        self.depth += 1;
    }

    /// Ends the parenthesis.
    pub fn close(&mut self) {
        self.depth = self.depth.saturating_sub(1);
        self.bit(")", "");
    }

    /// Jumps where the result of logic operation is true; behind it, it is true in any case.
    pub fn jump_if(&mut self, label: &str) {
        self.instruction("JC", label);
        self.rlo = Some(true);
    }

    /// Jumps where the result of logic operation is false; behind it, it is true in any case.
    pub fn jump_unless(&mut self, label: &str) {
        self.instruction("JCN", label);
        self.rlo = Some(true);
    }

    /// Jumps.
    pub fn jump(&mut self, label: &str) {
        self.instruction("JU", label);
    }

    /// What comes now: the labels within it depend on that, and not on how many came before.
    pub fn about(&mut self, what: &str) {
        // FNV-1a.
        let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        self.about = what.bytes().fold(0xcbf2_9ce4_8422_2325, step);
    }

    /// A label that nothing else is called like.
    pub fn new_label(&mut self) -> String {
        let all = LETTERS.len() as u64 * (SIGNS.len() as u64).pow(3);
        self.about = self.about.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let mut number = (self.about >> 32) % all;
        while !self.labels.insert(number) && (self.labels.len() as u64) < all {
            number = (number + 1) % all;
        }
        let mut label = String::with_capacity(4);
        label.push(char::from(LETTERS[(number % LETTERS.len() as u64) as usize]));
        let mut rest = number / LETTERS.len() as u64;
        for _ in 0..3 {
            label.push(char::from(SIGNS[(rest % SIGNS.len() as u64) as usize]));
            rest /= SIGNS.len() as u64;
        }
        label
    }

    /// Whether each label was given once.
    pub fn labels_suffice(&self) -> bool {
        self.labels.len() < LABELS_A_LETTER as usize * LETTERS.len()
    }

    /// Where a jump leads: to the next instruction, which has one label at most.
    pub fn label(&mut self, label: String) {
        self.instruct_label();
        self.label = Some(label);
        (self.rlo, self.known) = (None, None);
    }

    /// A label that is due gets an instruction of its own.
    pub fn instruct_label(&mut self) {
        if self.label.is_some() {
            self.instruction("NOP", "0");
        }
    }

    /// The variable of ours at a place among those of its type.
    pub fn part(&mut self, names: &mut AwlNames, place: usize, ty: Type, stem: &str) -> EcoString {
        let of_type = self.parts.iter().filter(|part| part.ty == ty);
        if let Some(part) = of_type.clone().nth(place) {
            return local(&part.name);
        }
        let name = names.namer.name(&format!("{stem}_{}", of_type.count() + 1));
        self.parts.push(Local { name: name.clone(), ty });
        local(&name)
    }
}
