//! Whole numbers as bits of diagrams: two's complement, the lowest bit first, the last one the sign.

use super::seen::Seen;
use super::sets::{Halt, Sets};
use biodivine_lib_bdd::{Bdd, BddVariableSet};
use grafc_formula::{Arithmetic, Comparison, Type, Value};

/// A number in as few bits as it takes.
pub(crate) fn whole(all: &BddVariableSet, n: i64) -> Vec<Bdd> {
    let width = (i64::BITS - (if n < 0 { !n } else { n }).leading_zeros()) as usize + 1;
    (0..width).map(|bit| if n >> bit.min(63) & 1 == 1 { all.mk_true() } else { all.mk_false() }).collect()
}

/// A value that is known.
pub(crate) fn of_value(all: &BddVariableSet, ty: Type, value: Value) -> Option<Seen> {
    match value {
        Value::Bool(b) => Some(Seen::Truth(if b { all.mk_true() } else { all.mk_false() })),
        Value::Int(n) if matches!(ty, Type::Real | Type::Lreal) => Some(Seen::Real(n as f64)),
        Value::Int(n) | Value::Time(n) => Some(Seen::Number(whole(all, n))),
        Value::Real(x) => Some(Seen::Real(x)),
    }
}

/// A value of a type, from its bits.
pub(crate) fn of_bits(all: &BddVariableSet, ty: Type, mut bits: Vec<Bdd>) -> Seen {
    match ty {
        Type::Bool => bits.pop().map_or_else(|| Seen::Truth(all.mk_false()), Seen::Truth),
        Type::Uint | Type::Udint => {
            bits.push(all.mk_false());
            Seen::Number(bits)
        }
        Type::Int | Type::Dint | Type::Time | Type::Real | Type::Lreal => Seen::Number(bits),
    }
}

/// A bit of a number, as far beyond its sign as one likes.
pub(crate) fn bit(number: &[Bdd], place: usize) -> &Bdd {
    &number[place.min(number.len() - 1)]
}

/// The value as a variable of a type takes it: it wraps around.
pub(crate) fn stored(all: &BddVariableSet, ty: Type, value: Seen) -> Option<Seen> {
    match (value, super::bits::width(ty)) {
        (Seen::Truth(truth), _) => Some(Seen::Truth(truth)),
        (Seen::Number(bits), Some(width)) => Some(wrapped(all, ty, bits, width)),
        (Seen::Real(x), None) => Some(Seen::Real(x)),
        (Seen::Number(_) | Seen::Real(_) | Seen::Given(_) | Seen::Elapsed(_), _) => None,
    }
}

fn wrapped(all: &BddVariableSet, ty: Type, bits: Vec<Bdd>, width: usize) -> Seen {
    let is_signed = !matches!(ty, Type::Uint | Type::Udint);
    if bits.len() <= width && (is_signed || bits.last().is_none_or(Bdd::is_false)) {
        return Seen::Number(bits);
    }
    of_bits(all, ty, (0..width).map(|place| bit(&bits, place).clone()).collect())
}

/// One or the other; none where they are not of a kind.
pub(crate) fn choice(when: &Bdd, yes: Seen, no: Seen, sets: &mut Sets) -> Result<Option<Seen>, Halt> {
    Ok(Some(match (yes, no) {
        (Seen::Truth(yes), Seen::Truth(no)) => Seen::Truth(sets.choice(when, &yes, &no)?),
        (Seen::Number(yes), Seen::Number(no)) => {
            let width = yes.len().max(no.len());
            let bits = (0..width).map(|place| sets.choice(when, bit(&yes, place), bit(&no, place)));
            Seen::Number(bits.collect::<Result<_, _>>()?)
        }
        (Seen::Real(yes), Seen::Real(no)) if yes.to_bits() == no.to_bits() => Seen::Real(yes),
        _ => return Ok(None),
    }))
}

pub(crate) fn compare_truths(op: Comparison, a: &Bdd, b: &Bdd, sets: &mut Sets) -> Result<Option<Bdd>, Halt> {
    match op {
        Comparison::Equal => sets.iff(a, b).map(Some),
        Comparison::NotEqual => sets.xor(a, b).map(Some),
        Comparison::Less | Comparison::LessEqual | Comparison::Greater | Comparison::GreaterEqual => Ok(None),
    }
}

pub(crate) fn compare(op: Comparison, a: &[Bdd], b: &[Bdd], sets: &mut Sets) -> Result<Bdd, Halt> {
    Ok(match op {
        Comparison::Equal => equal(a, b, sets)?,
        Comparison::NotEqual => equal(a, b, sets)?.not(),
        Comparison::Less => less(a, b, sets)?,
        Comparison::GreaterEqual => less(a, b, sets)?.not(),
        Comparison::Greater => less(b, a, sets)?,
        Comparison::LessEqual => less(b, a, sets)?.not(),
    })
}

fn equal(a: &[Bdd], b: &[Bdd], sets: &mut Sets) -> Result<Bdd, Halt> {
    let mut same = sets.iff(bit(a, 0), bit(b, 0))?;
    for place in 1..a.len().max(b.len()) {
        let here = sets.iff(bit(a, place), bit(b, place))?;
        same = sets.and(&same, &here)?;
    }
    Ok(same)
}

fn less(a: &[Bdd], b: &[Bdd], sets: &mut Sets) -> Result<Bdd, Halt> {
    let width = a.len().max(b.len());
    if width == 1 {
        return sets.minus(bit(a, 0), bit(b, 0));
    }
    // Below the signs, from the lowest bit on.
    let mut less = sets.minus(bit(b, 0), bit(a, 0))?;
    for place in 1..width {
        let (a, b) = (bit(a, place), bit(b, place));
        // At the sign, the one that has it is less.
        let decided = if place + 1 == width { sets.minus(a, b)? } else { sets.minus(b, a)? };
        let same = sets.iff(a, b)?;
        let so_far = sets.and(&same, &less)?;
        less = sets.or(&decided, &so_far)?;
    }
    Ok(less)
}

pub(crate) fn negate(all: &BddVariableSet, ty: Type, a: &[Bdd], sets: &mut Sets) -> Result<Seen, Halt> {
    let zero = [all.mk_false()];
    Ok(arithmetic(all, ty, Arithmetic::Subtract, &zero, a, sets)?.unwrap_or(Seen::Number(zero.to_vec())))
}

/// Sums and differences, and products with what is known; none for others.
pub(crate) fn arithmetic(
    all: &BddVariableSet,
    ty: Type,
    op: Arithmetic,
    a: &[Bdd],
    b: &[Bdd],
    sets: &mut Sets,
) -> Result<Option<Seen>, Halt> {
    let Some(width) = super::bits::width(ty) else { return Ok(None) };
    let bits = match op {
        Arithmetic::Add => sum(a, b, all.mk_false(), width, sets)?,
        Arithmetic::Subtract => {
            let less: Vec<Bdd> = b.iter().map(Bdd::not).collect();
            sum(a, &less, all.mk_true(), width, sets)?
        }
        Arithmetic::Multiply => {
            let is_known = |number: &[Bdd]| number.iter().all(|bit| bit.is_true() || bit.is_false());
            let (factor, known) = if is_known(b) {
                (a, b)
            } else if is_known(a) {
                (b, a)
            } else {
                return Ok(None);
            };
            let mut out = vec![all.mk_false()];
            for place in 0..width {
                if bit(known, place).is_true() {
                    let mut shifted = vec![all.mk_false(); place];
                    shifted.extend(factor.iter().cloned());
                    out = sum(&out, &shifted, all.mk_false(), width, sets)?;
                    out.truncate(width.max(1));
                }
            }
            out
        }
        Arithmetic::Divide | Arithmetic::Modulo => return Ok(None),
    };
    Ok(Some(wrapped(all, ty, bits, width)))
}

/// One bit more than both have, so that nothing is lost before it wraps around; of at most such a width.
fn sum(a: &[Bdd], b: &[Bdd], mut carry: Bdd, width: usize, sets: &mut Sets) -> Result<Vec<Bdd>, Halt> {
    let mut out = Vec::with_capacity(width + 1);
    for place in 0..=(a.len().max(b.len())).min(width) {
        let (x, y) = (bit(a, place), bit(b, place));
        let either = sets.xor(x, y)?;
        out.push(sets.xor(&either, &carry)?);
        let both = sets.and(x, y)?;
        let carried = sets.and(&either, &carry)?;
        carry = sets.or(&both, &carried)?;
    }
    Ok(out)
}
