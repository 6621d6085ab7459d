//! Division by everything, zero included. What is expected is worked out from the rule.

use grafc_runtime::{Number, divide, remainder};

/// Quotient and remainder with the flag that both must leave down.
fn both<N: Number>(a: N, b: N) -> (N, N) {
    let mut div0 = false;
    let results = (divide(a, b, &mut div0), remainder(a, b, &mut div0));
    assert!(!div0);
    results
}

/// Quotient and remainder by a zero: each must raise the flag by itself.
fn by_zero<N: Number>(a: N, zero: N) -> (N, N) {
    let (mut in_quotient, mut in_remainder) = (false, false);
    let results = (divide(a, zero, &mut in_quotient), remainder(a, zero, &mut in_remainder));
    assert!(in_quotient && in_remainder);
    results
}

#[test]
fn integers_are_truncated_toward_zero_and_remainders_have_the_sign_of_the_dividend() {
    assert_eq!(both(7_i16, 2), (3, 1));
    assert_eq!(both(-7_i16, 2), (-3, -1));
    assert_eq!(both(7_i32, -2), (-3, 1));
    assert_eq!(both(-7_i32, -2), (3, -1));
    assert_eq!(both(-7_i64, 2), (-3, -1));
    assert_eq!(both(65_535_u16, 256), (255, 255));
    assert_eq!(both(4_294_967_295_u32, 65_536), (65_535, 65_535));
}

#[test]
fn the_least_integer_by_minus_one_wraps_around() {
    assert_eq!(both(i16::MIN, -1), (-32_768, 0));
    assert_eq!(both(i32::MIN, -1), (-2_147_483_648, 0));
    assert_eq!(both(i64::MIN, -1), (i64::MIN, 0));
    assert_eq!(both(i16::MAX, -1), (-32_767, 0));
}

#[test]
fn integers_by_zero_are_zero() {
    assert_eq!(by_zero(5_i16, 0), (0, 0));
    assert_eq!(by_zero(5_u16, 0), (0, 0));
    assert_eq!(by_zero(i32::MIN, 0), (0, 0));
    assert_eq!(by_zero(u32::MAX, 0), (0, 0));
    assert_eq!(by_zero(-5_i64, 0), (0, 0));
    assert_eq!(by_zero(0_i16, 0), (0, 0));
}

#[test]
fn reals_are_ieee_754() {
    assert_eq!(both(7.5_f32, 2.0), (3.75, 1.5));
    assert_eq!(both(-7.5_f64, 2.0), (-3.75, -1.5));
    assert_eq!(both(7.5_f64, -2.0), (-3.75, 1.5));
    // 10^300 / 10^-300 is out of range.
    assert_eq!(both(1e300_f64, 1e-300).0, f64::INFINITY);
    assert_eq!(both(1.0_f64, f64::INFINITY), (0.0, 1.0));
    assert!(both(1.0_f32, f32::NAN).0.is_nan());
    assert!(both(f64::INFINITY, 2.0).1.is_nan());
}

#[test]
fn reals_by_a_zero_of_either_sign_are_zero() {
    for zero in [0.0, -0.0] {
        for a in [1.5, -1.5, 0.0, f64::INFINITY, f64::NAN] {
            let (quotient, remainder) = by_zero(a, zero);
            // The bits, since the result is the zero without a sign.
            assert_eq!((quotient.to_bits(), remainder.to_bits()), (0, 0), "{a} by {zero}");
            let (quotient, remainder) = by_zero(a as f32, zero as f32);
            assert_eq!((quotient.to_bits(), remainder.to_bits()), (0, 0), "{a} by {zero}");
        }
    }
}

#[test]
fn the_flag_stays_raised() {
    let mut div0 = true;
    assert_eq!(divide(6, 3, &mut div0), 2);
    assert!(div0);
    assert_eq!(remainder(6.0, 4.0, &mut div0), 2.0);
    assert!(div0);
}
