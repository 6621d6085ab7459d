//! A whole source file, in both languages.

use crate::awl::{Mnemonics, Options, emit};
use crate::st::tests::four_steps;
use expect_test::expect;

/// The same instructions in the other words.
#[test]
fn german_mnemonics() {
    let (english, german) = (Options { organization_block: true, ..Options::default() }, Mnemonics::German);
    let german = Options { mnemonics: german, ..english.clone() };
    let [english, german] = [english, german].map(|options| emit(&four_steps(), &options).expect("it can be written"));
    let pairs = english.lines().zip(german.lines()).filter(|(e, g)| e != g);
    let words =
        |line: &str| line.split("//").next().map(|text| text.split_ascii_whitespace().collect::<Vec<_>>().join(" "));
    let mut pairs: Vec<(String, String)> = pairs.filter_map(|(e, g)| Some((words(e)?, words(g)?))).collect();
    pairs.dedup();
    let found = |e: &str, g: &str| assert!(pairs.contains(&(e.into(), g.into())), "{e} is not {g}: {pairs:?}");
    found("A #RESTART;", "U #RESTART;");
    found("S5S7: AN #started;", "S5S7: UN #started;");
    let jumps =
        |e: &str, g: &str| pairs.iter().any(|(a, b)| a.strip_prefix(e).is_some_and(|l| b.strip_prefix(g) == Some(l)));
    assert!(jumps("JCN ", "SPBN ") && jumps("JC ", "SPB "), "{pairs:?}");
    found("AD DW#16#7FFFFFFF;", "UD DW#16#7FFFFFFF;");
    found("start := I 0.0,", "start := E 0.0,");
    found("INLET := Q 0.0,", "INLET := A 0.0,");
    assert_eq!(Mnemonics::German.operator("JU"), "SPA");
    assert_eq!(english.lines().count(), german.lines().count());
}

#[test]
fn four_steps_in_full() {
    let options = Options { organization_block: true, header: vec!["a header".into()], ..Options::default() };
    let text = emit(&four_steps(), &options).expect("it can be written");
    expect![[r#"
        // a header

        FUNCTION_BLOCK FB 1
        TITLE =Filling
        // filling and stirring a tank
        NAME : Filling
        VERSION : 0.1
        VAR_INPUT
            start : BOOL;                         // start button
            high : BOOL;
            low : BOOL;
            NOW : TIME;                           // milliseconds of a clock, such as that of SFC 64
            RESTART : BOOL;                       // start anew
        END_VAR
        VAR_OUTPUT
            INLET : BOOL;                         // inlet valve
            STIRRER : BOOL;
            OUTLET : BOOL;
            LIVELOCK : BOOL;                      // the situation did not become stable
        END_VAR
        VAR
            // constants
            stir_time : DINT := L#8000;
            // internal variables
            batches : INT;                        // how often the tank was filled
            // steps
            X1 : BOOL := TRUE;                    // ready
            X2 : BOOL;                            // fill
            X3 : BOOL;
            X4 : BOOL;
            // timers
            stirred : BOOL;                       // stir_time/X3
            stirred_run : BOOL;
            stirred_start : DINT;
            // memory from call to call
            started : BOOL;
            old_start : BOOL;
            // values within one call
            clear_1 : BOOL;
            clear_2 : BOOL;
            clear_3 : BOOL;
            clear_4 : BOOL;
            next_1 : BOOL;
            next_2 : BOOL;
            next_3 : BOOL;
            next_4 : BOOL;
            again : BOOL;
            micro_steps : WORD;
            last_now : DINT;                      // NOW at the call before
            clock : DINT;                         // milliseconds, counted from call to call
        END_VAR
        BEGIN
        NETWORK
        TITLE =the clock: milliseconds since the call before
              L     #NOW;
              L     #last_now;
              -D;
              AD    DW#16#7FFFFFFF;
              L     L#1073741824;
              >D;
              JC    MMNS;                         // NOW was put back: no time
              TAK;
              L     #clock;
              +D;
              T     #clock;
        MMNS: L     #NOW;
              T     #last_now;

        NETWORK
        TITLE =restart: as before the first call
              A     #RESTART;
              JCN   S5S7;
              R     #INLET;
              R     #STIRRER;
              R     #OUTLET;
              S     #X1;
              R     #X2;
              R     #X3;
              R     #X4;
              R     #LIVELOCK;
              R     #started;
              R     #old_start;
              R     #stirred;
              R     #stirred_run;
              L     L#0;
              T     #batches;
              T     #stirred_start;

        NETWORK
        TITLE =one call
        S5S7: AN    #started;
              JCN   JVHX;
        // memory of edges
              S     #started;
              A     #start;
              =     #old_start;
        JVHX: L     0;
              T     #micro_steps;
        S8NF: L     #micro_steps;                 // one micro-step
              L     1;
              +I;
              T     #micro_steps;

        NETWORK
        TITLE =conditions
              A     #X3;                          // stir_time/X3
              FP    #stirred_run;
              JCN   W9J4;
              L     #clock;
              T     #stirred_start;
        W9J4: L     #clock;
              L     #stirred_start;
              -D;
              L     #stir_time;
              >=D;
              O     #stirred;
              A     #stirred_run;
              =     #stirred;

        NETWORK
        TITLE =transitions that clear
              A     #X1;                          // 1 -> 2: rise start
              A     #start;
              AN    #old_start;
              =     #clear_1;
              A     #X2;                          // 2 -> 3: high
              A     #high;
              =     #clear_2;
              A     #X3;                          // 3 -> 4: stir_time/X3
              A     #stirred;
              =     #clear_3;
              A     #X4;                          // 4 -> 1: not low
              AN    #low;
              =     #clear_4;

        NETWORK
        TITLE =next situation
              O     #clear_4;
              O;
              A     #X1;
              AN    #clear_1;
              =     #next_1;
              O     #clear_1;
              O;
              A     #X2;
              AN    #clear_2;
              =     #next_2;
              O     #clear_2;
              O;
              A     #X3;
              AN    #clear_3;
              =     #next_3;
              O     #clear_3;
              O;
              A     #X4;
              AN    #clear_4;
              =     #next_4;
              X     #next_1;
              X     #X1;
              O(;
                X     #next_2;
                X     #X2;
              );
              O(;
                X     #next_3;
                X     #X3;
              );
              O(;
                X     #next_4;
                X     #X4;
              );
              O(;
                X     #start;
                X     #old_start;
              );
              =     #again;

        NETWORK
        TITLE =stored actions
              A     #clear_2;
              JCN   RTWT;
              L     #batches;                     // 2 -> 3: on clearing
              L     1;
              +I;
              T     #batches;

        NETWORK
        TITLE =situation
        RTWT: A     #next_1;
              =     #X1;
              A     #next_2;
              =     #X2;
              A     #next_3;
              =     #X3;
              A     #next_4;
              =     #X4;
              A     #start;
              =     #old_start;

        NETWORK
        TITLE =another micro-step, until the situation is stable
              L     #micro_steps;
              L     L#200;
              <D;
              A     #again;
              JC    S8NF;
              A     #again;
              S     #LIVELOCK;

        NETWORK
        TITLE =outputs
              A     #X2;
              =     #INLET;
              A     #X3;
              =     #STIRRER;
              A     #X4;                          // 4 ->: until empty
              =     #OUTLET;
              BE;
        END_FUNCTION_BLOCK

        DATA_BLOCK DB 1
        TITLE =Filling: what it keeps
        FB 1
        BEGIN
            stir_time := L#8000;
            X1 := TRUE;
        END_DATA_BLOCK

        ORGANIZATION_BLOCK OB 1
        TITLE =calls Filling
        VERSION : 0.1
        VAR_TEMP
            OB1_EV_CLASS : BYTE;
            OB1_SCAN_1 : BYTE;
            OB1_PRIORITY : BYTE;
            OB1_OB_NUMBR : BYTE;
            OB1_RESERVED_1 : BYTE;
            OB1_RESERVED_2 : BYTE;
            OB1_PREV_CYCLE : INT;
            OB1_MIN_CYCLE : INT;
            OB1_MAX_CYCLE : INT;
            OB1_DATE_TIME : DATE_AND_TIME;
            now : TIME;
            restart : BOOL;
        END_VAR
        BEGIN
        NETWORK
        TITLE =the clock of the CPU
              CALL  SFC 64 (RET_VAL := #now);

        NETWORK
        TITLE =the first cycle after a warm or a cold restart
              L     #OB1_SCAN_1;
              L     B#16#1;
              ==I;
              O(;
                L     #OB1_SCAN_1;
                L     B#16#4;
                ==I;
              );
              =     #restart;

        NETWORK
        TITLE =the chart
              CALL  FB 1, DB 1 (
                    start := I 0.0,
                    INLET := Q 0.0,
                    NOW := #now,
                    RESTART := #restart);
              BE;
        END_ORGANIZATION_BLOCK
    "#]]
    .assert_eq(&text);
}
