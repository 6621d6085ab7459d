//! Formulas of truth values.

use super::{BITS, list};
use crate::st::tests::{Build, assign, body};
use grafc_formula::{FormulaId, Type};

#[test]
fn conditions_are_chains() {
    let check = |build: fn(&mut Build, &[FormulaId]) -> FormulaId, expected: &str| {
        let program = body(&BITS, Type::Bool, |b, read, y| vec![assign(y, build(b, read))]);
        assert_eq!(list(&program), format!("{expected}, = #y"));
    };
    check(|_, i| i[0], "A #f5");
    check(|b, i| b.pool().not(i[0]), "AN #f5");
    check(|b, _| b.pool().truth(true), "SET");
    check(|b, i| b.pool().or([i[0], i[1]]), "O #f5, O #g");
    check(
        |b, i| {
            let not = b.pool().not(i[0]);
            b.pool().xor(i[1], not)
        },
        "X #g, XN #f5",
    );
    // AND goes before OR.
    check(
        |b, i| {
            let (both, not) = (b.pool().and([i[0], i[1]]), b.pool().not(i[4]));
            let others = b.pool().and([i[2], i[3]]);
            b.pool().or([both, not, others])
        },
        "A #f5, A #g, ON #k, O, A #h, A #j",
    );
    // The first sum needs no parenthesis, the second does.
    check(
        |b, i| {
            let (first, second) = (b.pool().or([i[0], i[1]]), b.pool().or([i[2], i[3]]));
            b.pool().and([i[4], first, second])
        },
        "O #f5, O #g, A #k, A(, O #h, O #j, )",
    );
    // A sum of products that goes on is no place for a bare O.
    check(
        |b, i| {
            let (first, second) = (b.pool().and([i[0], i[1]]), b.pool().and([i[2], i[3]]));
            let sum = b.pool().or([first, second]);
            b.pool().and([sum, i[4]])
        },
        "A #f5, A #g, O(, A #h, A #j, ), A #k",
    );
    check(
        |b, i| {
            let (first, second) = (b.pool().and([i[0], i[1]]), b.pool().and([i[2], i[3]]));
            let sum = b.pool().or([first, second]);
            b.pool().not(sum)
        },
        "A #f5, A #g, O(, A #h, A #j, ), NOT",
    );
    // Within a parenthesis it is one: the parenthesis ends with it.
    check(
        |b, i| {
            let (first, second) = (b.pool().and([i[0], i[1]]), b.pool().and([i[2], i[3]]));
            let (sum, not) = (b.pool().or([first, second]), b.pool().not(i[0]));
            let (other, not_sum) = (b.pool().or([i[4], not]), b.pool().not(sum));
            let deeper = b.pool().xor(i[2], i[3]);
            let all = b.pool().and([not_sum, other]);
            b.pool().or([deeper, all])
        },
        "X #h, X #j, O, AN(, A #f5, A #g, O, A #h, A #j, ), A(, O #k, ON #f5, )",
    );
}

/// Seven parentheses may be open; the formula below opens one more with each step.
#[test]
fn what_is_too_deep_goes_through_a_variable() {
    let nest = |levels: usize| {
        body(&BITS, Type::Bool, |b, i, y| {
            // Each step is a product of two sums, the second of which holds the step before.
            let (first, second) = (b.pool().or([i[0], i[1]]), b.pool().or([i[2], i[3]]));
            let mut value = b.pool().and([first, second]);
            for _ in 0..levels {
                let other = b.pool().xor(i[3], i[4]);
                let inner = b.pool().xor(value, other);
                value = inner;
            }
            vec![assign(y, value)]
        })
    };
    for levels in [1, 6, 7, 20, 40] {
        let text = list(&nest(levels));
        let mut depth = 0;
        let mut deepest = 0;
        for word in text.split(", ") {
            depth += i32::from(word.ends_with('('));
            deepest = deepest.max(depth);
            depth -= i32::from(word == ")");
        }
        assert_eq!(depth, 0, "{text}");
        assert!(deepest <= 7, "{text}");
    }
    // A pyramid: operands as deep on both sides.
    let pyramid = body(&BITS, Type::Bool, |b, i, y| {
        let mut level: Vec<FormulaId> = (0..256)
            .map(|n| {
                let not = b.pool().not(i[n % 5]);
                b.pool().xor(i[(n / 5) % 5], not)
            })
            .collect();
        while level.len() > 1 {
            level = level
                .chunks(2)
                .map(|pair| {
                    let either = b.pool().or([pair[0], pair[1], i[0]]);
                    let both = b.pool().and([pair[0], pair[1], i[1]]);
                    b.pool().xor(either, both)
                })
                .collect();
        }
        vec![assign(y, level[0])]
    });
    let list = list(&pyramid);
    assert!(list.contains("= #part_1"), "{list}");
    let open = |(depth, deepest): (i32, i32), word: &str| {
        let depth = depth + i32::from(word.ends_with('(')) - i32::from(word == ")");
        (depth, deepest.max(depth))
    };
    assert_eq!(list.split(", ").fold((0, 0), open), (0, 7));
}
