//! Saving and restoring.

use grafc_runtime::{Restorer, SEAL_LEN, Saved, Saver, Timer, crc32, seal};

/// Saves `value` alone, compares the bytes and takes the value back.
#[track_caller]
fn check<V: Saved + Copy + PartialEq + std::fmt::Debug>(value: V, bytes: &[u8]) {
    let mut buffer = [0xAA; 8];
    Saver::new(&mut buffer).put(value);
    assert_eq!(buffer[..V::LEN], *bytes);
    assert!(buffer[V::LEN..].iter().all(|&byte| byte == 0xAA));

    let mut restorer = Restorer::new(bytes);
    assert_eq!(restorer.take(), Some(value));
    assert!(restorer.is_done());

    // With one byte less there is no value, and nothing is written.
    assert_eq!(Restorer::new(&bytes[1..]).take::<V>(), None);
    assert_eq!(V::read(&bytes[1..]), None);
    let mut short = [0xAA; 8];
    Saver::new(&mut short[1..V::LEN]).put(value);
    value.write(&mut short[1..V::LEN]);
    assert_eq!(short, [0xAA; 8]);
}

#[test]
fn each_type_goes_there_and_back() {
    check(false, &[0]);
    check(true, &[1]);
    check(0xFE_u8, &[0xFE]);
    check(0x1234_u16, &[0x34, 0x12]);
    check(-2_i16, &[0xFE, 0xFF]);
    check(0x1234_5678_u32, &[0x78, 0x56, 0x34, 0x12]);
    check(-2_i32, &[0xFE, 0xFF, 0xFF, 0xFF]);
    check(0x0102_0304_0506_0708_u64, &[8, 7, 6, 5, 4, 3, 2, 1]);
    check(i64::MIN, &[0, 0, 0, 0, 0, 0, 0, 0x80]);
    // 1.5 is 1.1 in binary: exponent 127 or 1023, the first bit of the fraction set.
    check(1.5_f32, &[0, 0, 0xC0, 0x3F]);
    check(-1.5_f64, &[0, 0, 0, 0, 0, 0, 0xF8, 0xBF]);
}

#[test]
fn a_real_that_is_no_number_keeps_its_bits() {
    let mut buffer = [0; 4];
    Saver::new(&mut buffer).put(f32::from_bits(0x7FC0_0001));
    let back = Restorer::new(&buffer).take::<f32>().map(f32::to_bits);
    assert_eq!(back, Some(0x7FC0_0001));
}

#[test]
fn values_stand_one_after_the_other() {
    let mut timer = Timer::new();
    timer.call(true, 100);
    timer.call(true, 358);
    let (running, elapsed) = timer.state();

    let mut buffer = [0xAA; 12];
    let mut saver = Saver::new(&mut buffer);
    saver.put(running);
    saver.put(elapsed);
    saver.put(-1_i16);
    assert_eq!(buffer, [1, 2, 1, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0xAA]);

    let mut restorer = Restorer::new(&buffer);
    assert_eq!(restorer.take(), Some(true));
    assert_eq!(restorer.take(), Some(258_i64));
    assert_eq!(restorer.take(), Some(-1_i16));
    assert!(!restorer.is_done());
    assert_eq!(restorer.take(), Some(0xAA_u8));
    assert!(restorer.is_done());
    assert_eq!(restorer.take::<u8>(), None);
}

#[test]
fn nothing_is_put_after_what_did_not_fit() {
    let mut buffer = [0xAA; 4];
    let mut saver = Saver::new(&mut buffer);
    saver.put(0x0201_u16);
    saver.put(0_u32);
    saver.put(3_u8);
    assert_eq!(buffer, [1, 2, 0xAA, 0xAA]);
}

#[test]
fn there_is_room_for_nothing_in_nothing() {
    Saver::new(&mut []).put(true);
    let mut restorer = Restorer::new(&[]);
    assert!(restorer.is_done());
    assert_eq!(restorer.take::<bool>(), None);
}

#[test]
fn bytes_that_are_no_bool_are_not_taken() {
    for bad in 2..=255 {
        let bytes = [bad];
        let mut restorer = Restorer::new(&bytes);
        assert_eq!(restorer.take::<bool>(), None);
        assert!(!restorer.is_done());
        assert_eq!(restorer.take(), Some(bad));
    }
}

#[test]
fn the_checksum_is_the_common_one() {
    // The check value in the catalogues of CRCs, and that of nothing.
    assert_eq!(crc32(b"123456789"), 0xCBF4_3926);
    assert_eq!(crc32(b""), 0);
    assert_eq!(crc32(&[0]), 0xD202_EF8D);
}

#[test]
fn what_was_sealed_is_taken_back() {
    let mut buffer = [0; 2 + SEAL_LEN];
    Saver::new(&mut buffer).put(0x1234_u16);
    seal(&mut buffer);
    assert_eq!(buffer[2..], crc32(&[0x34, 0x12]).to_le_bytes());
    let mut restorer = Restorer::sealed(&buffer).unwrap();
    assert_eq!(restorer.take(), Some(0x1234_u16));
    assert!(restorer.is_done());
}

#[test]
fn what_has_changed_is_not() {
    let mut buffer = [0x5A; 60];
    seal(&mut buffer);
    for one in 0..buffer.len() * 8 {
        for other in 0..=one {
            let mut bytes = buffer;
            bytes[one / 8] ^= 1 << (one % 8);
            if other < one {
                bytes[other / 8] ^= 1 << (other % 8);
            }
            assert!(Restorer::sealed(&bytes).is_none(), "bits {one} and {other}");
        }
    }
    assert!(Restorer::sealed(&buffer[1..]).is_none());
    assert!(Restorer::sealed(&buffer[..59]).is_none());
}

#[test]
fn erased_memory_is_not_sealed() {
    assert!(Restorer::sealed(&[0xFF; 60]).is_none());
    assert!(Restorer::sealed(&[0; 60]).is_none());
    assert!(Restorer::sealed(&[1, 2, 3]).is_none());
    let mut short = [1, 2, 3];
    seal(&mut short);
    assert_eq!(short, [1, 2, 3]);
}
