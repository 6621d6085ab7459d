//! The blocks of the file: the function block with its declarations, its data block, `OB 1`.

use super::code::Code;
use super::numbers::literal;
use super::{AwlNames, Local, Mnemonics, Options};
use crate::comment::clean;
use crate::iec::declarations::{self, EntryType, VarKind};
use crate::iec::literals::is_zero;
use crate::iec::names::{Names, remark};
use crate::keywords::Family;
use crate::writer::Writer;
use ecow::{EcoString, eco_format};
use grafc_formula::{Type, Value};
use grafc_logic::scan::{Origin, Program, Role, Variable};
use rustc_hash::FxHashMap;

/// The name in the header of a block has no more characters.
const LONGEST_NAME: usize = 8;
/// Where comments beside declarations begin, if the declaration is shorter.
const REMARKS: usize = 40;

/// What STEP 7 gives to `OB 1`: twenty bytes, named as it names them.
const OB1: [(&str, &str); 10] = [
    ("OB1_EV_CLASS", "BYTE"),
    ("OB1_SCAN_1", "BYTE"),
    ("OB1_PRIORITY", "BYTE"),
    ("OB1_OB_NUMBR", "BYTE"),
    ("OB1_RESERVED_1", "BYTE"),
    ("OB1_RESERVED_2", "BYTE"),
    ("OB1_PREV_CYCLE", "INT"),
    ("OB1_MIN_CYCLE", "INT"),
    ("OB1_MAX_CYCLE", "INT"),
    ("OB1_DATE_TIME", "DATE_AND_TIME"),
];

/// Writes all blocks; a block stands before what refers to it.
pub(super) fn write(out: &mut Writer, program: &Program, options: &Options, names: &AwlNames, code: Code) {
    out.block_comment(options.header.iter().map(|line| clean(line)));
    out.blank();
    let number = options.number;
    out.line(&format!("FUNCTION_BLOCK FB {number}"));
    head(out, &names.block);
    out.comment(&remark(&program.name, &names.block, program.comment.as_deref()).unwrap_or_default());
    let name: String = names.block.chars().take(LONGEST_NAME).collect();
    out.line(&format!("NAME : {}", name.trim_end_matches('_')));
    out.line("VERSION : 0.1");
    interface(out, program, names, &code.parts);
    out.line("BEGIN");
    out.append(code.out);
    out.line("END_FUNCTION_BLOCK");
    out.blank();
    out.line(&format!("DATA_BLOCK DB {number}"));
    head(out, &format!("{}: what it keeps", names.block));
    out.line(&format!("FB {number}"));
    out.open("BEGIN");
    // STEP 7 takes them from the declarations, awlsim from here alone.
    for (id, variable) in program.variables.iter_enumerated().filter(|(_, v)| v.role != Role::Input) {
        if !is_zero(variable.initial()) {
            out.line(&format!("{} := {};", names.variables[id], initial_value(variable.initial(), variable.ty)));
        }
    }
    out.close("END_DATA_BLOCK");
    if options.organization_block {
        out.blank();
        organization_block(out, program, options, names);
    }
}

fn head(out: &mut Writer, title: &str) {
    out.line(&format!("TITLE ={title}"));
}

/// The declarations, one a line.
fn interface(out: &mut Writer, program: &Program, names: &AwlNames, parts: &[Local]) {
    let initial: FxHashMap<&str, &Variable> =
        program.variables.iter_enumerated().map(|(id, v)| (names.variables[id].as_str(), v)).collect();
    let origins = out.is_traced().then(|| program.origins());
    let given = Names::new(program, Family::StatementList);
    let blocks = declarations::interface_from(program, &given, origins.as_ref(), Vec::new());
    let mut blocks: Vec<declarations::VarBlock> = blocks.collect();
    blocks.sort_by_key(|block| match block.kind {
        VarKind::Input => 0,
        VarKind::Output => 1,
        VarKind::Constant | VarKind::Local | VarKind::Temporary => 2,
    });
    let mut open: Option<&str> = None;
    let mut section = |out: &mut Writer, keyword: &'static str| {
        if open != Some(keyword) {
            if open.is_some() {
                out.close("END_VAR");
            }
            out.open(keyword);
            open = Some(keyword);
        }
    };
    let mut timers = names.timers.iter();
    for block in &blocks {
        let keyword = match block.kind {
            VarKind::Input => "VAR_INPUT",
            VarKind::Output => "VAR_OUTPUT",
            VarKind::Constant | VarKind::Local | VarKind::Temporary => "VAR",
        };
        for (heading, entries) in &block.sections {
            if !entries.is_empty() {
                section(out, keyword);
                let heading = if block.kind == VarKind::Constant { "constants" } else { heading.as_ref() };
                out.comment(heading);
            }
            for entry in entries {
                out.origin(entry.origin);
                let comment = entry.comment.as_deref();
                match &entry.ty {
                    EntryType::Elementary(ty) => {
                        let value = initial.get(entry.name.as_str()).map(|v| v.initial()).filter(|v| !is_zero(*v));
                        declaration(out, &entry.name, *ty, value.filter(|_| block.kind != VarKind::Input), comment);
                    }
                    EntryType::Timer => {
                        let kept = timers.next().map(|timer| timer.kept()).unwrap_or_default();
                        for (place, part) in kept.iter().enumerate() {
                            declaration(out, &part.name, part.ty, None, comment.filter(|_| place == 0));
                        }
                    }
                    // The function block holds no other.
                    EntryType::Block(_) => {}
                }
            }
            out.origin(Origin::Chart);
        }
        match block.kind {
            VarKind::Input => {
                section(out, keyword);
                if let Some(clock) = &names.clock {
                    declaration(
                        out,
                        &clock.now,
                        Type::Time,
                        None,
                        Some("milliseconds of a clock, such as that of SFC 64"),
                    );
                }
                declaration(out, &names.restart, Type::Bool, None, Some("start anew"));
            }
            VarKind::Local => {
                if names.clock.is_some() || !parts.is_empty() {
                    section(out, keyword);
                }
                for (part, comment) in names.clock.iter().flat_map(|clock| clock.kept()) {
                    declaration(out, &part.name, part.ty, None, Some(comment));
                }
                if !parts.is_empty() {
                    out.comment("parts of formulas");
                }
                for part in parts {
                    declaration(out, &part.name, part.ty, None, None);
                }
            }
            VarKind::Output | VarKind::Temporary | VarKind::Constant => {}
        }
    }
    out.close("END_VAR");
}

/// A TIME with an initial value is a DINT of milliseconds: awlsim cuts the literals of TIME to one millisecond less.
fn declaration(out: &mut Writer, name: &str, ty: Type, initial: Option<Value>, comment: Option<&str>) {
    let declared = if ty == Type::Time && initial.is_some() { "DINT" } else { type_name(ty) };
    let initial = initial.map(|value| format!(" := {}", initial_value(value, ty))).unwrap_or_default();
    let text = format!("{name} : {declared}{initial};");
    let behind = comment.filter(|comment| out.fits_behind((out.indent() + text.len()).max(REMARKS), comment));
    if behind.is_none() {
        out.comment(comment.unwrap_or_default());
    }
    out.start();
    out.text(&text);
    if let Some(comment) = behind {
        out.trailing_comment(out.indent() + text.len(), REMARKS, comment);
    }
    out.end();
}

/// A constant as a declaration takes it.
fn initial_value(value: Value, ty: Type) -> EcoString {
    match (value, ty) {
        (Value::Int(n), Type::Uint) => eco_format!("W#16#{n:X}"),
        (Value::Int(n), Type::Udint) => eco_format!("DW#16#{n:X}"),
        (value, ty) => literal(value, ty),
    }
}

fn type_name(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "BOOL",
        Type::Int => "INT",
        Type::Dint => "DINT",
        Type::Uint => "WORD",
        Type::Udint => "DWORD",
        // There is no double precision: see `fit`.
        Type::Real | Type::Lreal => "REAL",
        Type::Time => "TIME",
    }
}

/// `OB 1`: reads the clock, tells a restart, calls the block with the variables at addresses.
fn organization_block(out: &mut Writer, program: &Program, options: &Options, names: &AwlNames) {
    let (number, mnemonics) = (options.number, options.mnemonics);
    out.line("ORGANIZATION_BLOCK OB 1");
    head(out, &format!("calls {}", names.block));
    out.line("VERSION : 0.1");
    out.open("VAR_TEMP");
    for (name, ty) in OB1 {
        out.line(&format!("{name} : {ty};"));
    }
    out.line("now : TIME;");
    out.line("restart : BOOL;");
    out.close("END_VAR");
    out.line("BEGIN");
    let mut code = Code::new(mnemonics, out.is_traced());
    if names.clock.is_some() {
        code.network("the clock of the CPU");
        code.instruction("CALL", "SFC 64 (RET_VAL := #now)");
    }
    code.network("the first cycle after a warm or a cold restart");
    let scan = |code: &mut Code, value: &str| {
        code.number("L", "#OB1_SCAN_1");
        code.number("L", value);
        code.comparison("==I");
    };
    scan(&mut code, "B#16#1");
    code.open("O");
    scan(&mut code, "B#16#4");
    code.close();
    code.assign("#restart");
    code.network("the chart");
    let mut arguments = Vec::new();
    for (id, variable) in program.variables.iter_enumerated() {
        let wired = match variable.role {
            Role::Input | Role::Output | Role::Flag(_) | Role::Internal => true,
            Role::Constant | Role::Step | Role::State | Role::Memory | Role::Temporary | Role::Observed => false,
        };
        if let Some(address) =
            variable.address.as_deref().filter(|_| wired).and_then(|a| address(a, variable.ty, mnemonics))
        {
            arguments.push(format!("{} := {address}", names.variables[id]));
        }
    }
    if let Some(clock) = &names.clock {
        arguments.push(format!("{} := #now", clock.now));
    }
    arguments.push(format!("{} := #restart", names.restart));
    let lines = arguments.join(",\n            ");
    code.instruction("CALL", &format!("FB {number}, DB {number} (\n            {lines})"));
    code.instruction("BE", "");
    out.append(code.out);
    out.line("END_ORGANIZATION_BLOCK");
}

/// An address as STEP 7 writes it, if it is one of the width of the type: `%IX0.1` is `I 0.1`, `%QW4` is `QW 4`.
fn address(address: &str, ty: Type, mnemonics: Mnemonics) -> Option<String> {
    let address = address.to_ascii_uppercase();
    let rest = address.strip_prefix('%')?;
    let area = rest.chars().next().filter(|area| matches!(area, 'I' | 'Q' | 'M'))?;
    let rest = &rest[1..];
    let (size, place) = match rest.strip_prefix(['X', 'B', 'W', 'D', 'L']) {
        Some(place) => (rest.chars().next()?, place),
        None => ('X', rest),
    };
    let is_number = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
    let fits = match ty {
        Type::Bool => {
            size == 'X'
                && place
                    .split_once('.')
                    .is_some_and(|(byte, bit)| is_number(byte) && matches!(bit.as_bytes(), [b'0'..=b'7']))
        }
        Type::Int | Type::Uint => size == 'W' && is_number(place),
        Type::Dint | Type::Udint | Type::Real | Type::Time => size == 'D' && is_number(place),
        Type::Lreal => false,
    };
    let size = if size == 'X' { String::new() } else { size.to_string() };
    fits.then(|| format!("{}{size} {place}", mnemonics.area(area)))
}
