//! Generated C, as a C compiler takes it and the machine runs it.
//!
//! The sources of many charts go into one program with a `main` of ours (`driver`), which plays each chart's trace and
//! prints what came out. Now and then it goes on with what was saved of a chart and restored. Whatever the compiler has to
//! say is a fault, and so is what is undefined in C.
//!
//! The same for microcontrollers, compiled and emulated (`boards`, `bare`), and for Arduino.

mod arduino;
mod bare;
mod boards;
mod driver;
mod executor;
mod run;
mod tools;

pub use arduino::Arduino;
pub use boards::{Board, Compiler, Emulated};
pub(super) use executor::C;
pub use run::run;
pub use tools::{Checks, Tools};

/// Every type, every operation, every kind of action; `lreal` is what an AVR has not.
pub const ALL_KINDS: &str = "\
chart Kinds
input go, p : bool
input i : int
input d : dint
input u : uint
input v : udint
input r : real
input t : time
output lamp : bool
output count : int
output share : udint
output part : real
output a : dint
output b : uint
output c : time
var pause : time := 3s
const rest : time := 2s
initial step 1 {
  count := count + 1 on activation
  a := (d * 3 - d / i) mod 7 on activation
  b := u * u + u / 3 - u mod 5 on activation
  c := t * 2 + t / 3 on activation
}
step 2 {
  lamp if 1s/X2/4s and p
  share := v / 3 mod v on event rise p
  part := r / 2.5 - -r on deactivation
  count := -i * i on deactivation
}
step 3 { a := -d on activation  c := -t on activation }
transition (t1) 1 -> 2 : rise go or fall p
transition (t2) 2 -> 3 : rest/X2 or [(T2 + pause) / 3 > rest]
transition (t3) 3 -> 1 : [i / count = 7 mod i] or 250ms/p
";
