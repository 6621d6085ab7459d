//! The table: one row a habit, each with a chart that has it and the same chart cured.
//!
//! The first row that knows a slip gives the help, so what is more special stands first.

use super::Habit;
use super::{actions, conditions, declarations, items, transitions};

macro_rules! rows {
    ($($wrong:literal => $right:literal, $cure:path;)*) => {
        &[$(Habit { wrong: $wrong, right: $right, cure: $cure }),*]
    };
}

#[rustfmt::skip]
pub(super) const TABLE: &[Habit] = rows! {
    "step 1\ntranstion 1 -> 2 : a" => "step 1\ntransition 1 -> 2 : a", items::misspelt;
    "step initial 1" => "initial step 1", items::mark_behind_step;
    "initial 1" => "initial step 1", items::step_missing;
    "step 1, 2" => "step 1\nstep 2", items::several_steps;

    "chart My chart\nstep 1" => "chart `My chart`\nstep 1", items::name_of_the_chart;
    "assert: not X1" => "assert not X1", items::colon_behind_the_word;
    "assert X1 leads X2" => "assert X1 leads to X2", items::leads_without_to;
    "allow W0409\nstep 1" => "allow W0409 \"interlocked by hardware\"\nstep 1", items::reason_missing;

    "transition t2: 2 -> 3 : a" => "transition (t2) 2 -> 3 : a", transitions::designation;
    "transition 1 to 2 : a" => "transition 1 -> 2 : a", transitions::words_for_the_arrow;
    "transition 1 => 2 : a" => "transition 1 -> 2 : a", transitions::arrow;
    "transition 1 and 2 -> 3 : a" => "transition 1, 2 -> 3 : a", transitions::synchronisation;
    "transition 1 -> (2) : a" => "transition 1 -> 2 : a", transitions::step_in_parentheses;
    "transition 1 -> 2 := a" => "transition 1 -> 2 : a", transitions::colon;
    "transition 1 -> 2" => "transition 1 -> 2 : 1", transitions::no_condition;

    "transition 1 -> 2 : /a" => "transition 1 -> 2 : not a", conditions::bar;
    "transition 1 -> 2 : a && b" => "transition 1 -> 2 : a & b", conditions::doubled;
    "transition 1 -> 2 : =1" => "transition 1 -> 2 : 1", conditions::equals_one;
    "transition 1 -> 2 : -a" => "transition 1 -> 2 : not a", declarations::negative;
    "transition 1 -> 2 : -S4" => "transition 1 -> 2 : `-S4`", declarations::designation;
    "transition 1 -> 2 : [n >< 3]" => "transition 1 -> 2 : [n <> 3]", conditions::relation_sign;
    "transition 1 -> 2 : n == 3" => "transition 1 -> 2 : [n = 3]", conditions::comparison;
    "transition 1 -> 2 : [a < b < c]" => "transition 1 -> 2 : [a < b and b < c]", conditions::chain;
    "transition 1 -> 2 : a↑" => "transition 1 -> 2 : ↑a", conditions::edge_behind;
    "transition 1 -> 2 : 1s/↑a" => "transition 1 -> 2 : 1s/a", conditions::delayed_edge;
    "transition 1 -> 2 : ↑not a" => "transition 1 -> 2 : ↑(not a)", conditions::bare_operand;
    "transition 1 -> 2 : 3 sec/X1" => "transition 1 -> 2 : 3s/X1", conditions::gap_in_duration;
    "transition 1 -> 2 : 1,5s/X1" => "transition 1 -> 2 : 1.5s/X1", conditions::decimal_comma;
    "transition 1 -> 2 : R_TRIG(start)" => "transition 1 -> 2 : ↑start", conditions::function;
    "transition 1 -> 2 : RE a" => "transition 1 -> 2 : ↑a", conditions::edge_word;
    "transition 1 -> 2 : a et b" => "transition 1 -> 2 : a and b", conditions::operator_word;
    "transition 1 -> 2 : nicht a" => "transition 1 -> 2 : not a", conditions::negating_word;
    "transition 1 -> 2 : after 5s" => "transition 1 -> 2 : 5s/X1", conditions::waiting_word;
    "transition 1 -> 2 : X 1" => "transition 1 -> 2 : X1", conditions::gap_in_activity;
    "transition 1 -> 2 : if a" => "transition 1 -> 2 : a", conditions::conditional_word;

    "step 1 { S: K }" => "step 1 { K := 1 on activation }", actions::qualifier_before_colon;
    "step 1 { D 5s K }" => "step 1 { K if 5s/X1 }", actions::qualifier_with_time;
    "step 1 { K(R) }" => "step 1 { K := 0 on activation }", actions::qualifier_behind;
    "step 1 { run P on activation }" => "step 1 { run P }", actions::run_at_an_event;
    "step 1 { K on activation }" => "step 1 { K := 1 on activation }", actions::value_missing;
    "step 1 { K := 1 on Activation }" => "step 1 { K := 1 on activation }", declarations::capitals;
    "step 1 { K := 1 on entry }" => "step 1 { K := 1 on activation }", actions::event;
    "step 1 { K := 1 if a }" => "step 1 { K := 1 on event ↑a }", actions::assignment_with_condition;
    "step 1 { if a then K }" => "step 1 { K if a }", actions::condition_before;
    "step 1 { ↑K := 1 }" => "step 1 { K := 1 on activation }", actions::arrow_before;
    "step 1 { n++ }" => "step 1 { n := n + 1 on activation }", actions::change;
    "step 1 { F/G1{1} }" => "step 1 { force G1{1} }", actions::order_of_the_standard;
    "step 1 { G1{1} }" => "step 1 { force G1{1} }", actions::order;
    "step 1 { force G1{initial} }" => "step 1 { force G1{INIT} }", actions::initial_situation;
    "step 1 { V, W }" => "step 1 { V W }", actions::comma;
    "var n : int = 3" => "var n : int := 3", declarations::equals;
    "step 1 { K = 1 }" => "step 1 { K := 1 on activation }", actions::equals;
    "step 1: V" => "step 1 { V }", actions::braces;

    "transition 1 -> 2 : a { n := 1 on activation }" => "transition 1 -> 2 : a { n := 1  }", transitions::clearing;
    "input bool a" => "input a : bool", declarations::type_first;
    "const pause = 3s" => "const pause : time := 3s", declarations::colon_missing;
    "input a" => "input a : bool", declarations::no_type;
    "input a : bool, b : int" => "input a : bool\ninput b : int", declarations::second_type;
    "input a at %IX0.0 : bool" => "input a : bool at %IX0.0", declarations::address_first;
    "input a : bool at IX0" => "input a : bool at %IX0", declarations::address;
    "var retain n : int" => "retain var n : int", declarations::retain_behind;
    "input start button : bool" => "input start_button : bool", declarations::name_of_two_words;
    "chart \"Mixer\"" => "chart Chart \"Mixer\"", declarations::title_without_name;
    "step 16#1" => "step 1", declarations::number_as_label;
    "input on : bool" => "input `on` : bool", declarations::reserved;

    "transition 1 -> 2 : a * b" => "transition 1 -> 2 : a · b", conditions::star;
    "transition 1 -> 2 : n - 1 > 3" => "transition 1 -> 2 : [n - 1 > 3]", conditions::arithmetic;
    "transition 1 -> 2 : a/b/c/d" => "transition 1 -> 2 : 3s/a/7s", conditions::many_delays;
    "transition 1 -> 2 : a b" => "transition 1 -> 2 : a · b", conditions::juxtaposed;
    "transition 1 -> 2 : a and" => "transition 1 -> 2 : a ", conditions::lonely_operator;
    "transition 1 -> 2 : (a or b" => "transition 1 -> 2 : (a or b)", conditions::partner;
    "grafcet G1" => "grafcet G1 { step 1 }", items::block_without_braces;
    "step 1\nfoo" => "step 1", items::no_item;
};
