//! Division that is defined for every divisor.
//!
//! A quotient or remainder by zero is 0 and raises the flag DIV0. Nothing else
//! can go wrong: integers wrap around, reals follow IEEE 754.

/// A type of number that can be divided. A duration is an `i64` of milliseconds.
pub trait Number: Copy {
    /// What a division by zero gives.
    const ZERO: Self;

    /// The quotient, truncated toward zero for integers. None if `by` is zero.
    fn quotient(self, by: Self) -> Option<Self>;

    /// The remainder, with the sign of the dividend. None if `by` is zero.
    fn rest(self, by: Self) -> Option<Self>;
}

/// The quotient of `a` and `b`. If `b` is zero it is 0, and `div0` is raised. The
/// flag is never lowered here.
#[inline]
pub fn divide<N: Number>(a: N, b: N, div0: &mut bool) -> N {
    match a.quotient(b) {
        Some(quotient) => quotient,
        None => {
            *div0 = true;
            N::ZERO
        }
    }
}

/// The remainder of `a` divided by `b`. If `b` is zero it is 0, and `div0` is
/// raised. The flag is never lowered here.
#[inline]
pub fn remainder<N: Number>(a: N, b: N, div0: &mut bool) -> N {
    match a.rest(b) {
        Some(rest) => rest,
        None => {
            *div0 = true;
            N::ZERO
        }
    }
}

/// Integers wrap around: the least number divided by -1 is itself, remainder 0.
macro_rules! integer_numbers {
    ($($integer:ty)*) => {$(
        impl Number for $integer {
            const ZERO: Self = 0;

            #[inline]
            fn quotient(self, by: Self) -> Option<Self> {
                if by == 0 { None } else { Some(self.wrapping_div(by)) }
            }

            #[inline]
            fn rest(self, by: Self) -> Option<Self> {
                if by == 0 { None } else { Some(self.wrapping_rem(by)) }
            }
        }
    )*};
}

/// Both zeros are zero; everything else is IEEE 754.
macro_rules! real_numbers {
    ($($real:ty)*) => {$(
        impl Number for $real {
            const ZERO: Self = 0.0;

            #[inline]
            fn quotient(self, by: Self) -> Option<Self> {
                if by == 0.0 { None } else { Some(self / by) }
            }

            #[inline]
            fn rest(self, by: Self) -> Option<Self> {
                if by == 0.0 { None } else { Some(self % by) }
            }
        }
    )*};
}

integer_numbers!(i16 u16 i32 u32 i64);
real_numbers!(f32 f64);
