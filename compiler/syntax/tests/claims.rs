//! Claims, and that their words stay names where no claim can begin.

mod common;

use common::{chart, check, faults, show};
use grafc_syntax::ast::{Chart, Claim, ClaimBody, ClaimKind, Item};

fn claims(chart: &Chart) -> Vec<&Claim> {
    let mut found = Vec::new();
    let mut open: Vec<&Item> = chart.items.iter().rev().collect();
    while let Some(item) = open.pop() {
        match item {
            Item::Claim(claim) => found.push(&**claim),
            Item::Grafcet(grafcet) => open.extend(grafcet.items.iter().rev()),
            Item::Expansion(expansion) => open.extend(expansion.items.iter().rev()),
            Item::Declaration(_) | Item::Step(_) | Item::Transition(_) | Item::Allow(_) | Item::Scenario(_) => {}
        }
    }
    found
}

/// The keyword, the text and the body of each claim.
fn shown(text: &str) -> Vec<String> {
    let chart = chart(text);
    let one = |claim: &Claim| {
        let condition = |id| show(&chart, id);
        let body = match &claim.body {
            ClaimBody::Condition(id) => condition(*id),
            ClaimBody::AtMostOne(list) => list.iter().map(|id| condition(*id)).collect::<Vec<_>>().join(", "),
            ClaimBody::After(step, holds) => format!("after {}: {}", condition(*step), condition(*holds)),
            ClaimBody::Leads(from, to) => format!("{} leads to {}", condition(*from), condition(*to)),
        };
        let text = claim.text.as_ref().map(|text| format!(" {:?}", text.text)).unwrap_or_default();
        format!("{}{text} {body}", claim.kind.keyword())
    };
    claims(&chart).into_iter().map(one).collect()
}

#[test]
fn every_form() {
    let text = "assume \"buttons are interlocked\" : not (x1 and x2)
        assume at most one of f0, f1 or f2, ↑f3
        assert \"never both\" : not (VA and VB) assert after X5 : VB
        assert \"it goes on\" : X6 leads to X11 reach X11 final [n > 3]
        assert \"mixing\" : after X6 : BM";
    let expected = [
        "assume \"buttons are interlocked\" (not (paren (and x1 x2)))",
        "assume f0, (or f1 f2), (rise f3)",
        "assert \"never both\" (not (paren (and VA VB)))",
        "assert after X5: VB",
        "assert \"it goes on\" X6 leads to X11",
        "reach X11",
        "final (predicate (> n 3))",
        "assert \"mixing\" after X6: BM",
    ];
    assert_eq!(shown(text), expected);
    assert!(check(text));
}

#[test]
fn claims_stand_wherever_steps_do() {
    let text =
        "assert X1 step 1 assert \"a\" : X1 grafcet G { assert X2 step 2 { V } assert X3 transition 1 -> 2 : a reach b
        expansion M { final c step 3 } assume d } input e : bool assume e";
    assert_eq!(claims(&chart(text)).len(), 8);
    assert!(check(text));
}

#[test]
fn words_of_claims_are_names_where_they_always_were() {
    let text = "chart final input assume, assert \"a\", reach, at, most, one, after, leads, to : bool
        output final : bool initial step assert \"a\" { final } step final { assume reach if assert }
        macro step reach expansion reach { step Ereach step Sreach }
        transition (2) \"back\" assert -> assume : final
        transition (assume) \"c\" reach, final -> reach : not assert or assume { n := final }
        transition assert -> final : 1s/reach + [reach = assert] allow W0401 assert \"r\" grafcet assume { step 4 { allow assert } }
        transition 1 -> at : at and after or leads";
    assert_eq!(claims(&chart(text)).len(), 0);
}

#[test]
fn words_of_claims_are_names_in_claims() {
    let text = "assert assert assert reach final final assume not assume reach after final leads
        assert leads leads to to assume at assert after after : after assume (at) and most assert \"x\" : assert
        assert after";
    let expected = [
        "assert assert",
        "assert reach",
        "final final",
        "assume (not assume)",
        "reach after",
        "final leads",
        "assert leads leads to to",
        "assume at",
        "assert after after: after",
        "assume (and (paren at) most)",
        "assert \"x\" assert",
        "assert after",
    ];
    assert_eq!(shown(text), expected);
}

#[test]
fn the_body_as_written_has_one_line() {
    let text = "assert // why\n  a   and // because\n\n (* b *) not (c\tor d)\nassume at  most one of a,b";
    let chart = chart(text);
    let written: Vec<&str> = claims(&chart).iter().map(|claim| claim.written.as_str()).collect();
    assert_eq!(written, ["a and not (c or d)", "at most one of a, b"]);
    assert_eq!(claims(&chart)[0].kind, ClaimKind::Assert);
}

#[test]
fn mistakes() {
    let cases = [
        ("assume at most one of a", "E0107 1:8-23 `at most one of` has one condition only"),
        ("reach after X5 : a", "E0107 1:1-5 `after …` can be asserted only"),
        ("final X1 leads to X2", "E0107 1:1-5 `… leads to …` can be asserted only"),
        ("assert \" \" : a", "E0107 1:8-10 the text of the claim is empty"),
        ("assert \"a\" a", "E0107 1:12 expected `:`, found `a`"),
        ("assert \"a\" :\nstep 1", "E0107 1:^13 expected a condition, found `step`"),
        ("assert a b", "E0107 1:10 expected an operator or the next item, found `b`"),
        ("step 1 { V assert \"a\" : b", "E0107 1:8 this `{` is never closed"),
    ];
    for (text, expected) in cases {
        assert_eq!(faults(text), [expected], "{text}");
    }
}

#[test]
fn the_format() {
    let text = "assert   \"a\":not(a and b)\n\n\n assume at most   one of a,b,\n c\nassert after   X5:VB reach X6 // why\nassert X1   leads to\nX2";
    let chart = chart(text);
    let expected = "assert \"a\" : not (a and b)\n\nassume at most one of a, b,\n    c\nassert after X5 : VB\nreach X6 // why\nassert X1 leads to X2\n";
    assert_eq!(grafc_syntax::format(text, &chart), expected);
    assert!(check(text));
}
