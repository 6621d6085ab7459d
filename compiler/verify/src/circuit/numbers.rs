//! Whole numbers as bits, the lowest first: two's complement of the width of their type.

use super::graph::{Graph, Literal};
use crate::atom::is_whole;
use crate::pack;
use grafc_formula::{Arithmetic, Comparison, Type};

/// A whole number.
pub(crate) type Bits = Vec<Literal>;

/// How many bits a whole number of a type has; none if it is of no such type.
pub(crate) fn width(ty: Type) -> Option<usize> {
    (is_whole(ty) && ty != Type::Bool).then(|| pack::width(ty) as usize)
}

/// Whether the numbers of a type have a sign.
pub(crate) fn is_signed(ty: Type) -> bool {
    match ty {
        Type::Int | Type::Dint | Type::Time => true,
        Type::Uint | Type::Udint | Type::Bool | Type::Real | Type::Lreal => false,
    }
}

/// A number that is known.
pub(crate) fn constant(ty: Type, number: i64) -> Bits {
    (0..width(ty).unwrap_or_default()).map(|bit| Literal::of(number >> bit & 1 == 1)).collect()
}

/// The same number, of another width.
pub(crate) fn widened(from: Type, a: &Bits, to: Type) -> Bits {
    let sign = if is_signed(from) { a[a.len() - 1] } else { Literal::FALSE };
    (0..width(to).unwrap_or_default()).map(|bit| a.get(bit).copied().unwrap_or(sign)).collect()
}

impl Graph {
    /// One of two numbers.
    pub(crate) fn choose_bits(&mut self, condition: Literal, then: &Bits, otherwise: &Bits) -> Bits {
        then.iter().zip(otherwise).map(|(a, b)| self.choose(condition, *a, *b)).collect()
    }

    /// `a + b + carry`, and what is carried out.
    fn sum(&mut self, a: &Bits, b: &Bits, mut carry: Literal) -> (Bits, Literal) {
        let mut sum = Bits::with_capacity(a.len());
        for (a, b) in a.iter().zip(b) {
            let one = self.xor(*a, *b);
            sum.push(self.xor(one, carry));
            let (both, with) = (self.and(*a, *b), self.and(one, carry));
            carry = self.or(both, with);
        }
        (sum, carry)
    }

    /// `a - b`, and whether `a` is not less than `b`, both without sign.
    fn difference(&mut self, a: &Bits, b: &Bits) -> (Bits, Literal) {
        let inverted = b.iter().map(|bit| !*bit).collect();
        self.sum(a, &inverted, Literal::TRUE)
    }

    /// `-a`.
    pub(crate) fn negated(&mut self, a: &Bits) -> Bits {
        let zero = vec![Literal::FALSE; a.len()];
        self.difference(&zero, a).0
    }

    fn negated_if(&mut self, condition: Literal, a: &Bits) -> Bits {
        let negated = self.negated(a);
        self.choose_bits(condition, &negated, a)
    }

    /// Whether a number is 0.
    pub(crate) fn is_zero(&mut self, a: &Bits) -> Literal {
        !self.any(a.iter().copied())
    }

    /// Whether a comparison of two numbers of a type holds.
    pub(crate) fn compare(&mut self, op: Comparison, ty: Type, a: &Bits, b: &Bits) -> Literal {
        match op {
            Comparison::Equal | Comparison::NotEqual => {
                let differ: Vec<Literal> = a.iter().zip(b).map(|(a, b)| self.xor(*a, *b)).collect();
                let differ = self.any(differ);
                if op == Comparison::Equal { !differ } else { differ }
            }
            Comparison::GreaterEqual => self.is_not_less(ty, a, b),
            Comparison::Less => !self.is_not_less(ty, a, b),
            Comparison::LessEqual => self.is_not_less(ty, b, a),
            Comparison::Greater => !self.is_not_less(ty, b, a),
        }
    }

    fn is_not_less(&mut self, ty: Type, a: &Bits, b: &Bits) -> Literal {
        let flipped = |bits: &Bits| {
            let mut bits = bits.clone();
            // With the sign turned around, the order is that of numbers without sign.
            if let Some(top) = bits.last_mut().filter(|_| is_signed(ty)) {
                *top = !*top;
            }
            bits
        };
        self.difference(&flipped(a), &flipped(b)).1
    }

    /// The result of an operation in a type, wrapped around; by zero it is whatever it is.
    pub(crate) fn arithmetic(&mut self, op: Arithmetic, ty: Type, a: &Bits, b: &Bits) -> Bits {
        match op {
            Arithmetic::Add => self.sum(a, b, Literal::FALSE).0,
            Arithmetic::Subtract => self.difference(a, b).0,
            Arithmetic::Multiply => self.product(a, b),
            Arithmetic::Divide | Arithmetic::Modulo => {
                let is_negative = |bits: &Bits| if is_signed(ty) { bits[bits.len() - 1] } else { Literal::FALSE };
                let (a_sign, b_sign) = (is_negative(a), is_negative(b));
                let (a, b) = (self.negated_if(a_sign, a), self.negated_if(b_sign, b));
                let (quotient, remainder) = self.quotient(&a, &b);
                if op == Arithmetic::Modulo {
                    return self.negated_if(a_sign, &remainder);
                }
                let sign = self.xor(a_sign, b_sign);
                self.negated_if(sign, &quotient)
            }
        }
    }

    fn product(&mut self, a: &Bits, b: &Bits) -> Bits {
        let mut product = vec![Literal::FALSE; a.len()];
        for (place, digit) in b.iter().enumerate() {
            let shifted: Bits = (0..a.len())
                .map(|bit| if bit < place { Literal::FALSE } else { self.and(a[bit - place], *digit) })
                .collect();
            product = self.sum(&product, &shifted, Literal::FALSE).0;
        }
        product
    }

    /// Quotient and remainder without signs, digit by digit as by hand.
    fn quotient(&mut self, a: &Bits, b: &Bits) -> (Bits, Bits) {
        let mut quotient = vec![Literal::FALSE; a.len()];
        // One bit wider, since twice the remainder may be.
        let mut divisor = b.clone();
        divisor.push(Literal::FALSE);
        let mut remainder = vec![Literal::FALSE; divisor.len()];
        for bit in (0..a.len()).rev() {
            remainder.pop();
            remainder.insert(0, a[bit]);
            let (less, fits) = self.difference(&remainder, &divisor);
            quotient[bit] = fits;
            remainder = self.choose_bits(fits, &less, &remainder);
        }
        remainder.pop();
        (quotient, remainder)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use grafc_formula::{Value, number};

    fn of(bits: &Bits, ty: Type) -> i64 {
        let unsigned = bits.iter().enumerate().fold(0i64, |n, (bit, literal)| {
            assert!(*literal == Literal::TRUE || *literal == Literal::FALSE, "it is known");
            n | i64::from(*literal == Literal::TRUE) << bit
        });
        let width = bits.len();
        if is_signed(ty) && width < 64 && unsigned >> (width - 1) == 1 { unsigned - (1 << width) } else { unsigned }
    }

    /// Constants fold, so that all is known: as the arithmetic of types has it.
    #[test]
    fn as_numbers_of_their_types() {
        let samples = |ty| match ty {
            Type::Int => vec![0, 1, -1, 2, 7, -7, 100, -300, 32_767, -32_768],
            Type::Uint => vec![0, 1, 2, 7, 255, 300, 32_768, 65_535],
            Type::Dint => vec![0, 1, -1, 3, -3, 70_000, -70_000, i64::from(i32::MAX), i64::from(i32::MIN)],
            _ => vec![0, 1, 3, 70_000, 4_294_967_295],
        };
        let ops = [Arithmetic::Add, Arithmetic::Subtract, Arithmetic::Multiply, Arithmetic::Divide, Arithmetic::Modulo];
        let comparisons = [
            Comparison::Equal,
            Comparison::NotEqual,
            Comparison::Less,
            Comparison::LessEqual,
            Comparison::Greater,
            Comparison::GreaterEqual,
        ];
        let mut graph = Graph::default();
        for ty in [Type::Int, Type::Uint, Type::Dint, Type::Udint] {
            for (a, b) in samples(ty).iter().flat_map(|a| samples(ty).into_iter().map(|b| (*a, b))) {
                let (bits_a, bits_b) = (constant(ty, a), constant(ty, b));
                assert_eq!(of(&bits_a, ty), a);
                for op in ops {
                    if b == 0 && matches!(op, Arithmetic::Divide | Arithmetic::Modulo) {
                        continue;
                    }
                    let expected = number::arithmetic(op, ty, Value::Int(a), Value::Int(b));
                    let found = graph.arithmetic(op, ty, &bits_a, &bits_b);
                    assert_eq!(Value::Int(of(&found, ty)), expected, "{a} {op:?} {b} as {ty:?}");
                }
                for op in comparisons {
                    let expected = number::compare(op, Value::Int(a), Value::Int(b));
                    assert_eq!(graph.compare(op, ty, &bits_a, &bits_b), Literal::of(expected), "{a} {op:?} {b} {ty:?}");
                }
            }
        }
        assert_eq!(of(&widened(Type::Int, &constant(Type::Int, -5), Type::Dint), Type::Dint), -5);
        assert_eq!(of(&widened(Type::Uint, &constant(Type::Uint, 65_531), Type::Dint), Type::Dint), 65_531);
    }
}
