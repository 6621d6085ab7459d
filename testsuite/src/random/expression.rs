//! Random conditions and arithmetic, as text.

use fastrand::Rng;
use grafc_model::chart::Type;

/// What an expression may name.
#[derive(Default)]
pub(super) struct Scope {
    /// Boolean inputs, stored Boolean variables and constants.
    pub bools: Vec<String>,
    /// Continuously assigned names, in an order in which each may read those before it.
    pub wires: Vec<String>,
    /// Variables and constants of every other type.
    pub numbers: Vec<(String, Type)>,
    /// The constants among them.
    pub constants: Vec<String>,
    /// Time constants, for delays.
    pub delays: Vec<String>,
    /// `X` + label, of steps, macro-steps and grafcets.
    pub activities: Vec<String>,
    /// `T` + label.
    pub durations: Vec<String>,
}

/// What a Boolean expression may hold in its place.
#[derive(Clone, Copy)]
pub(super) struct Allowed {
    pub edges: bool,
    pub delays: bool,
    /// So many of the wires.
    pub wires: usize,
    /// Inside brackets or on a right side, where `+` adds.
    pub arithmetic: bool,
}

/// An arithmetic expression, and whether it is made of constants alone.
struct Number {
    text: String,
    constant: bool,
}

impl Number {
    fn changing(text: String) -> Number {
        Number { text, constant: false }
    }

    fn constant(text: String) -> Number {
        Number { text, constant: true }
    }
}

fn pick<'a, T>(rng: &mut Rng, of: &'a [T]) -> Option<&'a T> {
    if of.is_empty() { None } else { Some(&of[rng.usize(0..of.len())]) }
}

fn one_of<'a>(rng: &mut Rng, of: &[&'a str]) -> &'a str {
    of[rng.usize(0..of.len())]
}

/// An expression as an operator that binds tightest takes it: a predicate as it is, every other time.
fn as_operand(expression: String) -> String {
    let depths = expression.chars().scan(0, |depth: &mut i32, c| {
        *depth += i32::from(c == '[') - i32::from(c == ']');
        Some(*depth)
    });
    let closed = depths.take(expression.chars().count().saturating_sub(1)).all(|depth| depth > 0);
    // The length decides, so that no draw is spent on it.
    if closed && expression.len() % 2 == 0 { expression } else { format!("({expression})") }
}

impl Scope {
    /// A Boolean expression; `depth` bounds its nesting.
    pub fn condition(&self, rng: &mut Rng, depth: u32, allowed: Allowed) -> String {
        if depth > 0 && rng.f32() < 0.4 {
            let left = self.operand(rng, depth - 1, allowed);
            let right = self.operand(rng, depth - 1, allowed);
            let operators: &[&str] = match (allowed.arithmetic, rng.u8(0..8)) {
                (_, 0) => &["xor"],
                (false, 1..4) => &["or", "+", "|"],
                (true, 1..4) => &["or"],
                (false, _) => &["and", "·", "&"],
                (true, _) => &["and"],
            };
            return format!("{left} {} {right}", one_of(rng, operators));
        }
        self.operand(rng, depth, allowed)
    }

    /// A Boolean expression that needs no parentheses around it.
    fn operand(&self, rng: &mut Rng, depth: u32, allowed: Allowed) -> String {
        let plain = Allowed { edges: false, ..allowed };
        for _ in 0..8 {
            match rng.u8(0..40) {
                0..8 => break,
                8..12 => {
                    if let Some(name) = pick(rng, &self.activities) {
                        return name.clone();
                    }
                }
                12..15 => return format!("{} {}", one_of(rng, &["not", "!", "¬"]), self.operand(rng, 0, plain)),
                15..17 if depth > 0 => return format!("({})", self.condition(rng, depth - 1, allowed)),
                17..19 if allowed.wires > 0 => return self.wires[rng.usize(0..allowed.wires)].clone(),
                19..26 if allowed.edges => return self.edge(rng, depth, plain),
                26..32 if allowed.delays => return self.delay(rng, depth, plain),
                32..38 => {
                    let inside = Allowed { delays: false, arithmetic: true, ..allowed };
                    return format!("[{}]", self.comparison(rng, depth, inside));
                }
                38 if rng.f32() < 0.2 => return one_of(rng, &["0", "1", "true", "false"]).to_string(),
                _ => {}
            }
        }
        pick(rng, &self.bools).or_else(|| self.activities.first()).cloned().unwrap_or_else(|| "1".into())
    }

    fn edge(&self, rng: &mut Rng, depth: u32, plain: Allowed) -> String {
        let sign = one_of(rng, &["↑", "↑", "↓", "rise ", "fall "]);
        let name = match rng.u8(0..10) {
            0..5 => pick(rng, &self.bools),
            5..7 => pick(rng, &self.activities),
            7 => pick(rng, &self.wires[..plain.wires]),
            _ => None,
        };
        match name {
            Some(name) => format!("{sign}{name}"),
            None => format!("{sign}{}", as_operand(self.condition(rng, depth.max(1), plain))),
        }
    }

    fn delay(&self, rng: &mut Rng, depth: u32, plain: Allowed) -> String {
        let operand = match rng.u8(0..10) {
            0..4 => pick(rng, &self.activities),
            4..7 => pick(rng, &self.bools),
            7 => pick(rng, &self.wires[..plain.wires]),
            _ => None,
        };
        let operand = match operand {
            Some(name) => name.clone(),
            None => {
                let nested = Allowed { delays: rng.f32() < 0.1, ..plain };
                as_operand(self.condition(rng, depth.max(1), nested))
            }
        };
        let mut time = || -> String {
            match rng.u8(0..12) {
                0..2 if !self.delays.is_empty() => self.delays[rng.usize(0..self.delays.len())].clone(),
                2 => one_of(rng, &["0s", "1ms", "T#1s500ms"]).to_string(),
                _ => one_of(rng, &["500ms", "1s", "1500ms", "2s", "3s", "5s"]).to_string(),
            }
        };
        let (on, off) = (time(), time());
        match rng.u8(0..5) {
            0..2 => format!("{on}/{operand}"),
            2..4 => format!("{on}/{operand}/{off}"),
            _ => format!("{operand}/{off}"),
        }
    }

    fn comparison(&self, rng: &mut Rng, depth: u32, inside: Allowed) -> String {
        if rng.f32() < 0.1 {
            return self.condition(rng, depth.max(1), inside);
        }
        let sign = one_of(rng, &["=", "<>", "<", "<=", ">", ">="]);
        if !self.durations.is_empty() && rng.f32() < 0.35 {
            let left = self.durations[rng.usize(0..self.durations.len())].clone();
            return format!("{left} {sign} {}", self.number(rng, Type::Time, 1));
        }
        match pick(rng, &self.numbers) {
            Some((name, ty)) => {
                let left = if rng.bool() { name.clone() } else { self.number(rng, *ty, 2) };
                // A literal on both sides would have no type of its own: a variable stands on one.
                let left = if left.starts_with(|c: char| c.is_ascii_digit() || c == '-') { name.clone() } else { left };
                format!("{left} {sign} {}", self.number(rng, *ty, 1))
            }
            None => self.condition(rng, depth, inside),
        }
    }

    /// An arithmetic expression of a type.
    pub fn number(&self, rng: &mut Rng, ty: Type, depth: u32) -> String {
        self.arithmetic(rng, ty, depth).text
    }

    fn arithmetic(&self, rng: &mut Rng, ty: Type, depth: u32) -> Number {
        if depth == 0 || rng.f32() >= 0.5 {
            return self.number_operand(rng, ty, depth);
        }
        let left = self.number_operand(rng, ty, depth - 1);
        if ty == Type::Time {
            // Products of times are kept small: charts run for hours, not for years.
            let left = left.text;
            return Number::changing(match rng.u8(0..16) {
                0 => format!("{left} / {}", one_of(rng, &["2", "3", "0"])),
                1 => format!("{} * {}", one_of(rng, &["1s", "250ms", "7ms"]), one_of(rng, &["2", "3", "10"])),
                2..8 => format!("{left} - {}", one_of(rng, &["1s", "1ms", "500ms"])),
                _ => format!("{left} + {}", one_of(rng, &["1s", "1ms", "500ms"])),
            });
        }
        // A constant that leaves its type is an error (E0210): one side changes.
        let left = match self.changing(rng, ty) {
            Some(name) if left.constant => name,
            None if left.constant => return left,
            _ => left.text,
        };
        let signs: &[&str] = match ty {
            Type::Real | Type::Lreal => &["+", "-", "*", "/"],
            Type::Int | Type::Dint | Type::Uint | Type::Udint => &["+", "+", "-", "*", "/", "mod"],
            Type::Bool | Type::Time => &["+"],
        };
        let sign = one_of(rng, signs);
        // A narrower variable beside one of the type itself: a conversion.
        if rng.f32() < 0.2
            && let (Some(wide), Some(narrow)) = (self.changing(rng, ty), self.narrower(rng, ty))
        {
            return Number::changing(match rng.bool() {
                true => format!("{wide} {sign} {narrow}"),
                false => format!("{narrow} {sign} {wide}"),
            });
        }
        Number::changing(format!("{left} {sign} {}", self.number_operand(rng, ty, depth - 1).text))
    }

    fn number_operand(&self, rng: &mut Rng, ty: Type, depth: u32) -> Number {
        let signed = matches!(ty, Type::Int | Type::Dint | Type::Real | Type::Lreal);
        match rng.u8(0..10) {
            0 if depth > 0 => {
                let inner = self.arithmetic(rng, ty, depth - 1);
                Number { text: format!("({})", inner.text), ..inner }
            }
            1 if signed => match self.changing(rng, ty) {
                Some(name) => Number::changing(format!("-{name}")),
                None => Number::constant(self.literal(rng, ty)),
            },
            2..4 if ty == Type::Time && !self.durations.is_empty() => {
                Number::changing(self.durations[rng.usize(0..self.durations.len())].clone())
            }
            4..8 => match self.variable_of(rng, |of| of == ty) {
                Some(name) => Number { constant: self.constants.contains(&name), text: name },
                None => Number::constant(self.literal(rng, ty)),
            },
            _ => Number::constant(self.literal(rng, ty)),
        }
    }

    /// A variable of the type that is no constant.
    fn changing(&self, rng: &mut Rng, ty: Type) -> Option<String> {
        let of_type = self.numbers.iter().filter(|(name, of)| *of == ty && !self.constants.contains(name));
        let names: Vec<&String> = of_type.map(|(name, _)| name).collect();
        pick(rng, &names).map(|name| (*name).clone())
    }

    /// A variable of another type that widens to this one without loss.
    fn narrower(&self, rng: &mut Rng, ty: Type) -> Option<String> {
        use Type::{Dint, Int, Lreal, Real, Udint, Uint};
        self.variable_of(rng, |of| {
            matches!(
                (of, ty),
                (Int, Dint | Lreal | Real) | (Dint | Udint | Real, Lreal) | (Uint, Udint | Dint | Real | Lreal)
            )
        })
    }

    fn variable_of(&self, rng: &mut Rng, fits: impl Fn(Type) -> bool) -> Option<String> {
        let fitting: Vec<&String> = self.numbers.iter().filter(|(_, ty)| fits(*ty)).map(|(name, _)| name).collect();
        pick(rng, &fitting).map(|name| (*name).clone())
    }

    /// A literal of a type; now and then one at the end of its range.
    pub fn literal(&self, rng: &mut Rng, ty: Type) -> String {
        let small = one_of(rng, &["0", "1", "1", "2", "3", "5", "10"]);
        let extreme = rng.f32() < 0.12;
        let choice: &[&str] = match ty {
            Type::Int if extreme => &["32767", "-32768", "16#7F", "-1"],
            Type::Dint if extreme => &["2147483647", "-2147483648", "16#FFFF", "-1"],
            Type::Uint if extreme => &["65535", "16#FFFF"],
            Type::Udint if extreme => &["4294967295", "3000000000"],
            Type::Real if extreme => &["16777217.0", "0.1", "-2.5", "3"],
            Type::Lreal if extreme => &["0.1", "-2.5", "9007199254740993.0", "7"],
            Type::Real | Type::Lreal => &["0.0", "1.0", "0.5", "8.5", "3.25", "2"],
            Type::Time => &["0s", "500ms", "1s", "1500ms", "2s", "3s", "1min30s"],
            Type::Int | Type::Dint | Type::Uint | Type::Udint => &[small],
            Type::Bool => &["0", "1", "true", "false"],
        };
        one_of(rng, choice).to_string()
    }
}
