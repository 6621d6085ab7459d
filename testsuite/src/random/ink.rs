//! What can be written in several ways, and what a text may have without meaning anything else: spellings, comments,
//! addresses. It is drawn apart, so that a chart stays the same whatever is added here.

use fastrand::Rng;
use grafc_model::chart::Type;
use std::fmt::Write as _;

/// Spellings of the same.
const SPELLINGS: [(&str, &str); 14] = [
    (" <> ", " ≠ "),
    (" <= ", " ≤ "),
    (" >= ", " ≥ "),
    (" · ", " ⋅ "),
    (" -> ", " → "),
    ("16#7F", "2#111_1111"),
    ("16#7F", "8#177"),
    ("32767", "32_767"),
    ("65535", "65_535"),
    ("2147483647", "2_147_483_647"),
    (" 3.25", " 32.5e-1"),
    (" 8.5", " 0.85e+1"),
    (" 0.1", " 1.0e-1"),
    (" 1min30s", " T#1m30s"),
];

/// A source of variety.
pub(super) struct Ink {
    rng: Rng,
    seed: u64,
    /// The next free number of an address.
    address: u32,
    /// What says which variables are retained.
    kept: Rng,
}

impl Ink {
    pub fn new(seed: u64) -> Self {
        let kept = Rng::with_seed(seed ^ 0x6b65_7074);
        Ink { rng: Rng::with_seed(seed ^ 0x696e_6b00), seed, address: 0, kept }
    }

    /// What it is drawn of.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// In one of twelve charts every step is left after a time at the latest; the source of these times.
    pub fn waits(&self) -> Option<Rng> {
        let mut rng = Rng::with_seed(self.seed ^ 0x7761_6974);
        (rng.u8(0..12) == 0).then_some(rng)
    }

    /// In one of twelve charts warnings are allowed: everywhere, of the first declaration, and in some braces.
    pub fn allow(&self, mut text: String) -> String {
        let mut rng = Rng::with_seed(self.seed ^ 0x616c_6c6f);
        if rng.u8(0..12) != 0 {
            return text;
        }
        for item in ["step ", "transition "] {
            let begins = |line: &str| line.trim_start().starts_with(item) && line.trim_end().ends_with('}');
            let lines = text.lines().filter(|line| begins(line)).map(str::to_owned).collect::<Vec<_>>();
            if let Some(line) = lines.get(rng.usize(0..lines.len().max(1))) {
                let inside = line.trim_end().strip_suffix('}').unwrap_or(line);
                text = text.replacen(line.as_str(), &format!("{inside} allow W0412 \"the plant sees to it\" }}"), 1);
            }
        }
        text.push_str("allow W0409 \"drawn at random\"\n");
        let declared = text.lines().find_map(|line| {
            let (keyword, rest) = line.split_once(' ')?;
            let name = rest.split([' ', ',']).next()?;
            (["input", "output", "var"].contains(&keyword) && !name.contains('`')).then(|| name.to_owned())
        });
        text.extend(declared.map(|name| format!("allow W0401 {name} \"it is meant\"\n")));
        text
    }

    /// Whether the next variable that stored actions set is kept over a restart.
    pub fn retains(&mut self) -> bool {
        self.kept.u8(0..5) < 2
    }

    /// True in this share of cases.
    pub fn chance(&mut self, share: f32) -> bool {
        self.rng.f32() < share
    }

    /// The source itself.
    pub fn rng(&mut self) -> &mut Rng {
        &mut self.rng
    }

    /// Now and then an attached comment, with a space before it.
    pub fn attached(&mut self, share: f32) -> &'static str {
        if self.chance(share) {
            [" \"says *) and (* \"", " \"Füllen, 50 %\"", " \"\""][self.rng.usize(0..3)]
        } else {
            ""
        }
    }

    /// Now and then a comment on lines of its own.
    pub fn remark(&mut self, out: &mut String) {
        if self.chance(0.05) {
            let remarks = ["// a remark (* not nested\n", "(* a remark *)\n", "(* a (* nested *) remark\n*)\n"];
            out.push_str(remarks[self.rng.usize(0..3)]);
        }
    }

    /// What follows the type in a declaration: the initial value, now and then an address, in either order.
    pub fn tail(&mut self, area: char, ty: Type, initial: &str) -> String {
        if !self.chance(0.12) {
            return initial.to_string();
        }
        self.address += 1;
        let n = self.address;
        let address = match ty {
            Type::Bool => format!(" at %{area}X{n}.{}", n % 8),
            Type::Int | Type::Uint => format!(" at %{area}W{n}"),
            Type::Dint | Type::Udint | Type::Real | Type::Time => format!(" at %{area}D{n}"),
            Type::Lreal => format!(" at %{area}L{n}"),
        };
        if self.chance(0.5) { format!("{initial}{address}") } else { format!("{address}{initial}") }
    }

    /// A text with other spellings here and there.
    pub fn respell(&mut self, text: &str) -> String {
        let mut text = text.to_string();
        for (from, to) in SPELLINGS {
            let mut parts = text.split(from);
            let mut out = parts.next().unwrap_or_default().to_string();
            for part in parts {
                let spelling = if self.rng.f32() < 0.3 { to } else { from };
                let _ = write!(out, "{spelling}{part}");
            }
            text = out;
        }
        text
    }
}
