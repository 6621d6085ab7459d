//! The two sets of words that STEP 7 knows for the same instructions. A source is compiled in the set that the editor is
//! set to.

/// The words of instructions and memory areas.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Mnemonics {
    /// The international ones: `A I 0.0`.
    #[default]
    English,
    /// The German ones: `U E 0.0`.
    German,
}

impl Mnemonics {
    /// An operator, given in English. Most are the same.
    pub(super) fn operator(self, english: &str) -> &str {
        match self {
            Mnemonics::English => english,
            Mnemonics::German => match english {
                "A" => "U",
                "AN" => "UN",
                "A(" => "U(",
                "AN(" => "UN(",
                "AD" => "UD",
                "JU" => "SPA",
                "JC" => "SPB",
                "JCN" => "SPBN",
                same => same,
            },
        }
    }

    /// A memory area, given by its letter in IEC 61131-3.
    pub(super) fn area(self, letter: char) -> char {
        match (self, letter) {
            (Mnemonics::German, 'I') => 'E',
            (Mnemonics::German, 'Q') => 'A',
            (Mnemonics::English | Mnemonics::German, same) => same,
        }
    }
}
