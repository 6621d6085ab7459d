//! Addresses: `at %IX0.6`, counted on over the names of a declaration.
//!
//! The forms are those of IEC 61131-3: area (`I`, `Q`, `M`), size (`X` or none, `B`, `W`, `D`, `L`), numbers between
//! points. Bits count to 7 and then on in the next byte; words count by words. Whether `%IW0` and `%IX0.0` share memory
//! depends on the PLC, so only equal addresses are taken for one.

use super::parts::Parts;
use super::types;
use crate::chart::{Type, Variable, VariableId, VariableKind};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix, Span};
use grafc_syntax::ast;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// A place in the memory of a PLC.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
struct Address {
    area: char,
    size: char,
    numbers: Vec<u32>,
}

/// Gives the variables the addresses in their declarations.
pub fn assign(parts: &Parts, variables: &mut IndexVec<VariableId, Variable>, diagnostics: &mut Diagnostics) {
    let mut taken: FxHashMap<Address, VariableId> = FxHashMap::default();
    let mut first = 0;
    for declaration in &parts.declarations {
        let ids = first..first + declaration.names.len();
        first = ids.end;
        let Some(text) = &declaration.address else { continue };
        let address = parse(&text.text);
        let fault = match &address {
            Some(address) => misfit(address, declaration, text.span),
            None => Some(malformed(text)),
        };
        if let Some(diagnostic) = fault {
            diagnostics.push(diagnostic);
            continue;
        }
        let mut next = address;
        for id in ids.map(VariableId::new) {
            let Some(address) = next else {
                let message = format!("no address is left for `{}` after `{}`", variables[id].name, text.text);
                diagnostics.push(
                    Diagnostic::new(Code::E0212, variables[id].span, message)
                        .also(text.span, "counted on from here")
                        .help("give it an address of its own, in another declaration"),
                );
                break;
            };
            let spelling = spell(&address, &text.text);
            if let Some(&other) = taken.get(&address) {
                let message = format!(
                    "`{}` and `{}` have the same address `{spelling}`",
                    variables[id].name, variables[other].name
                );
                diagnostics.push(
                    Diagnostic::new(Code::E0213, variables[id].span, message)
                        .also(variables[other].span, format!("`{}` has it already", variables[other].name))
                        .note("several names of one declaration get consecutive addresses")
                        .help("give one of them another address"),
                );
            }
            next = following(&address);
            taken.entry(address).or_insert(id);
            variables[id].address = Some(spelling.into());
        }
    }
}

/// Reads `%IX0.0`, in any case.
fn parse(text: &str) -> Option<Address> {
    let rest = text.strip_prefix('%')?;
    let mut letters = rest.chars();
    let area = letters.next()?.to_ascii_uppercase();
    if !matches!(area, 'I' | 'Q' | 'M') {
        return None;
    }
    let mut numbers = letters.as_str();
    let size = match letters.next()?.to_ascii_uppercase() {
        size @ ('X' | 'B' | 'W' | 'D' | 'L') => {
            numbers = letters.as_str();
            size
        }
        _ => 'X',
    };
    let numbers = numbers.split('.').map(number).collect::<Option<Vec<u32>>>()?;
    let bit_fits = size != 'X' || numbers.len() < 2 || numbers.last().is_some_and(|&bit| bit < 8);
    bit_fits.then_some(Address { area, size, numbers })
}

/// Digits only: `u32::from_str` would take a sign.
fn number(text: &str) -> Option<u32> {
    if text.bytes().all(|b| b.is_ascii_digit()) { text.parse().ok() } else { None }
}

/// The address after this one: the next bit, byte or word.
fn following(address: &Address) -> Option<Address> {
    let mut next = address.clone();
    let last = next.numbers.len() - 1;
    let is_bit_of_byte = address.size == 'X' && last > 0;
    if is_bit_of_byte && next.numbers[last] == 7 {
        next.numbers[last] = 0;
        next.numbers[last - 1] = next.numbers[last - 1].checked_add(1)?;
    } else {
        next.numbers[last] = next.numbers[last].checked_add(1)?;
    }
    Some(next)
}

/// The address in capitals; `%I0.0` stays without its `X`.
fn spell(address: &Address, written: &str) -> String {
    let is_sized = written.chars().nth(2).is_some_and(|c| c.is_ascii_alphabetic());
    if is_sized { full(address) } else { format!("%{}{}", address.area, places(address)) }
}

/// The address with its size.
fn full(address: &Address) -> String {
    format!("%{}{}{}", address.area, address.size, places(address))
}

fn places(address: &Address) -> String {
    address.numbers.iter().map(u32::to_string).collect::<Vec<_>>().join(".")
}

/// The error on an area or a size that does not suit the kind or the type of what is declared.
fn misfit(address: &Address, declaration: &ast::Declaration, span: Span) -> Option<Diagnostic> {
    let (what, areas): (&str, &[char]) = match kind(declaration.kind) {
        VariableKind::Input => ("an input", &['I', 'M']),
        VariableKind::Output => ("an output", &['Q', 'M']),
        VariableKind::Internal => ("an internal variable", &['M']),
        VariableKind::Constant => ("a constant", &[]),
    };
    if !areas.contains(&address.area) {
        let message = format!("{what} cannot be at `%{}{}`", address.area, address.size);
        let allowed: Vec<String> = areas.iter().map(|area| format!("`%{area}`")).collect();
        let note = match allowed.is_empty() {
            true => "a constant has no place in memory".to_owned(),
            false => format!("{what} is at {}", allowed.join(" or ")),
        };
        return Some(with_area(Diagnostic::new(Code::E0212, span, message).note(note), address, areas, span));
    }
    let ty = declaration.ty?;
    let size = match ty {
        Type::Bool => 'X',
        Type::Int | Type::Uint => 'W',
        Type::Dint | Type::Udint | Type::Real | Type::Time => 'D',
        Type::Lreal => 'L',
    };
    if address.size != size {
        let ty = types::name(ty);
        let message = format!("a variable of type `{ty}` cannot be at `%{}{}`", address.area, address.size);
        let written = resized(address, size);
        return Some(
            Diagnostic::new(Code::E0212, span, message)
                .also(declaration.ty_span, "the type is here")
                .help(format!("`{ty}` takes the size `{size}`, as in `%{}{size}{}`", address.area, example(size)))
                .fix(Fix::maybe(format!("write `{written}`")).replace(span, written)),
        );
    }
    None
}

/// The address with another size: a bit has its place in a byte, and nothing else has.
fn resized(address: &Address, size: char) -> String {
    let mut numbers = address.numbers.clone();
    match (address.size, size) {
        (_, 'X') => numbers.push(0),
        ('X', _) if numbers.len() > 1 => _ = numbers.pop(),
        _ => {}
    }
    full(&Address { size, numbers, ..address.clone() })
}

fn example(size: char) -> &'static str {
    if size == 'X' { "0.0" } else { "0" }
}

/// Offers the area that was meant, if there is one: `E` and `A` are the inputs and outputs of STEP 7 in German.
fn with_area(diagnostic: Diagnostic, address: &Address, areas: &[char], span: Span) -> Diagnostic {
    let Some(area) = areas.first() else { return diagnostic.help("leave the address out") };
    let written = full(&Address { area: *area, ..address.clone() });
    diagnostic.help(format!("write `{written}`")).fix(Fix::maybe(format!("write `{written}`")).replace(span, written))
}

fn malformed(text: &ast::Text) -> Diagnostic {
    let diagnostic = Diagnostic::new(Code::E0212, text.span, format!("`{}` is not an address", text.text)).note(
        "an address is `%`, the area `I`, `Q` or `M`, the size `X`, `B`, `W`, `D` or `L`, and numbers: `%IX0.7`, `%QW3`; \
         bits go from 0 to 7",
    );
    let mnemonic = text.text.get(1..2).map(str::to_uppercase);
    let area = match mnemonic.as_deref() {
        Some("E") => "I",
        Some("A") => "Q",
        _ => return diagnostic.help("write an address of this form"),
    };
    let written = format!("%{area}{}", &text.text[2..]);
    match parse(&written) {
        Some(_) => diagnostic
            .note("`E` and `A` are German for `I` and `Q`")
            .help(format!("write `{written}`"))
            .fix(Fix::maybe(format!("write `{written}`")).replace(text.span, written)),
        None => diagnostic.help("write an address of this form"),
    }
}

/// The kind of variable that a keyword declares.
pub fn kind(keyword: ast::DeclarationKind) -> VariableKind {
    match keyword {
        ast::DeclarationKind::Input => VariableKind::Input,
        ast::DeclarationKind::Output => VariableKind::Output,
        ast::DeclarationKind::Variable => VariableKind::Internal,
        ast::DeclarationKind::Constant => VariableKind::Constant,
    }
}

#[cfg(test)]
mod tests {
    use super::{following, parse, spell};
    use crate::checks::testing::{breaks, chart, help};

    fn count(first: &str, how_many: usize) -> Vec<String> {
        let addresses = std::iter::successors(parse(first), following);
        addresses.take(how_many).map(|address| spell(&address, first)).collect()
    }

    #[test]
    fn bits_go_on_in_the_next_byte() {
        assert_eq!(count("%IX0.6", 3), ["%IX0.6", "%IX0.7", "%IX1.0"]);
        assert_eq!(count("%q0.7", 2), ["%Q0.7", "%Q1.0"]);
        assert_eq!(count("%MX2.3.7", 2), ["%MX2.3.7", "%MX2.4.0"]);
        assert_eq!(count("%IX7", 2), ["%IX7", "%IX8"]);
    }

    #[test]
    fn words_go_by_words() {
        assert_eq!(count("%IW3", 2), ["%IW3", "%IW4"]);
        assert_eq!(count("%QD1.9", 2), ["%QD1.9", "%QD1.10"]);
    }

    #[test]
    fn the_numbers_end() {
        assert_eq!(count("%IW4294967295", 2).len(), 1);
    }

    #[test]
    fn other_forms_are_no_addresses() {
        for text in [
            "",
            "%",
            "%I",
            "%IX",
            "IX0.0",
            "%KX0.0",
            "%IX0.8",
            "%IX0.",
            "%IX.1",
            "%IX-1",
            "%IX+1",
            "%IW99999999999",
            "%IZ0",
            "%IX0,1",
        ] {
            assert_eq!(parse(text), None, "{text}");
        }
    }

    #[test]
    fn names_of_one_declaration_count_on() {
        let chart = chart("input a, b, c : bool at %IX0.6 output n, m : int at %qw3 initial step 1");
        let addresses: Vec<&str> = chart.variables.iter().filter_map(|v| v.address.as_deref()).collect();
        assert_eq!(addresses, ["%IX0.6", "%IX0.7", "%IX1.0", "%QW3", "%QW4"]);
    }

    #[test]
    fn an_address_suits_kind_and_type() {
        breaks("E0212", "input a : bool at %IX0.9 initial step 1");
        breaks("E0212", "input a : bool at %QX0.0 initial step 1");
        breaks("E0212", "output a : bool at %IX0.0 initial step 1");
        breaks("E0212", "var a : bool at %IX0.0 initial step 1");
        breaks("E0212", "const a : bool := 1 at %MX0.0 initial step 1");
        breaks("E0212", "input a : int at %IX0.0 initial step 1");
        breaks("E0212", "input a : bool at %IW0 initial step 1");
        breaks("E0212", "input a, b : int at %IW4294967295 initial step 1");
    }

    #[test]
    fn the_area_that_is_meant_is_offered() {
        let written = |text: &str| help(&format!("{text} initial step 1")).unwrap_or_default();
        assert_eq!(written("output a : bool at %IX0.0"), "write `%QX0.0`");
        assert_eq!(written("input a : bool at %QX3.5"), "write `%IX3.5`");
        assert_eq!(written("var a : int at %QW3"), "write `%MW3`");
        assert_eq!(written("input a : bool at %E0.1"), "write `%I0.1`");
    }

    #[test]
    fn an_address_is_taken_once() {
        breaks("E0213", "input a, b : bool at %IX0.7 input c : bool at %IX1.0 initial step 1");
        breaks("E0213", "input a : bool at %IX0.7 input c : bool at %i0.7 initial step 1");
    }
}
