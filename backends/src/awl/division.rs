//! Quotients and remainders.
//!
//! Which divisors the CPU must not divide by, the scan program says. There is no division without sign, so that of 32 bits is made of one with sign: see [`Numbers::long_division`].

use super::AwlNames;
use super::code::Code;
use super::numbers::{HIGHEST_BIT, Numbers, of_width, zero};
use grafc_formula::{FormulaId, Type, Value};
use grafc_logic::scan::{ByMinusOne, Division, Guard};

impl Numbers<'_> {
    /// A quotient or a remainder, where the divisor is not zero.
    pub(super) fn quotient(
        self,
        code: &mut Code,
        names: &mut AwlNames,
        modulo: bool,
        a: FormulaId,
        b: FormulaId,
        ty: Type,
    ) {
        let divisor = self.program.pool.as_constant(b);
        match (ty, self.ty(b)) {
            (Type::Real, _) => {
                self.load(code, names, a);
                self.load(code, names, b);
                code.number("/R", "");
            }
            (Type::Udint, _) => self.long_division(code, names, modulo, a, b),
            // No time of 32 bits holds such a divisor once.
            (Type::Time, Type::Udint) if matches!(divisor, Some(Value::Int(n)) if n > i64::from(i32::MAX)) => {
                code.number("L", "L#0");
            }
            _ => {
                self.load_long(code, names, a);
                self.load_long(code, names, b);
                code.number(if modulo { "MOD" } else { "/D" }, "");
            }
        }
    }

    /// A division under the guards that it needs.
    pub fn divide(self, code: &mut Code, names: &mut AwlNames, division: &Division) {
        let Division { target, modulo, dividend: a, divisor: b, flag, .. } = *division;
        let result = self.program.variables[target].ty;
        let (target, flag) = (names.variable(target), names.variable(flag));
        let guard = self.program.guard(division);
        if guard == Guard::Never {
            code.number("L", zero(result));
            code.instruction("T", &target);
            code.truth(true);
            return code.instruction("S", &flag);
        }
        let (go, store) = (code.new_label(), code.new_label());
        self.load(code, names, b);
        code.number("L", zero(self.ty(b)));
        code.comparison(of_width(self.ty(b), ["==I", "==D", "==R"]));
        code.jump_unless(&go);
        code.instruction("S", &flag);
        code.number("L", zero(result));
        code.jump(&store);
        code.label(go);
        if let Guard::ZeroAndMinusOne { quotient, fits: _ } = guard {
            let go = code.new_label();
            self.load(code, names, b);
            code.number("L", "L#-1");
            code.comparison("==D");
            code.jump_unless(&go);
            match quotient {
                ByMinusOne::Zero => code.number("L", "L#0"),
                ByMinusOne::Dividend | ByMinusOne::Negative => {
                    self.load(code, names, a);
                    code.number("NEGD", "");
                }
            }
            code.jump(&store);
            code.label(go);
        }
        if (result, self.ty(b)) == (Type::Time, Type::Udint) {
            // A divisor with the highest bit set is more than any time.
            let go = code.new_label();
            self.load(code, names, b);
            code.number("L", "L#0");
            code.comparison("<D");
            code.jump_unless(&go);
            code.number("L", "L#0");
            code.jump(&store);
            code.label(go);
        }
        self.quotient(code, names, modulo, a, b, result);
        code.label(store);
        code.instruction("T", &target);
    }

    /// The quotient or remainder of numbers of 32 bits without sign, by division with sign.
    ///
    /// By a divisor below 2^31: twice the quotient of the half is the quotient, or one less. By another: 0 or 1.
    fn long_division(self, code: &mut Code, names: &mut AwlNames, modulo: bool, a: FormulaId, b: FormulaId) {
        let quotient = code.part(names, 0, Type::Udint, "number");
        let rest = code.part(names, 1, Type::Udint, "number");
        let (large, compare, done) = (code.new_label(), code.new_label(), code.new_label());
        let divisor = self.program.pool.as_constant(b);
        let least = |b: Value| matches!(b, Value::Int(n) if n <= i64::from(i32::MAX));
        if divisor.is_none() {
            self.load(code, names, b);
            code.number("L", "L#0");
            code.comparison("<D");
            code.jump_if(&large);
        }
        if divisor.is_none_or(least) {
            self.load(code, names, a);
            code.number("SRD", "1");
            self.load(code, names, b);
            code.number("/D", "");
            code.number("SLD", "1");
            code.instruction("T", &quotient);
            self.load(code, names, b);
            code.number("*D", "");
            self.load(code, names, a);
            code.number("TAK", "");
            code.number("-D", "");
            code.instruction("T", &rest);
        }
        if divisor.is_none() {
            code.jump(&compare);
        }
        if !divisor.is_some_and(least) {
            if divisor.is_none() {
                code.label(large);
            }
            code.number("L", "L#0");
            code.instruction("T", &quotient);
            self.load(code, names, a);
            code.instruction("T", &rest);
        }
        if divisor.is_none() {
            code.label(compare);
        }
        code.number("L", &rest);
        code.number("XOD", HIGHEST_BIT);
        self.load_turned(code, names, b);
        code.comparison("<D");
        code.jump_if(&done);
        code.number("L", &quotient);
        code.number("L", "L#1");
        code.number("+D", "");
        code.instruction("T", &quotient);
        code.number("L", &rest);
        self.load(code, names, b);
        code.number("-D", "");
        code.instruction("T", &rest);
        code.label(done);
        code.number("L", if modulo { &rest } else { &quotient });
    }
}
