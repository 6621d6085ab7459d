//! Words that a target will not take as identifiers, in upper case: IEC identifiers know no case.
//!
//! Measured rather than only read: MATIEC, IronPLC and STruC++ refuse more than IEC 61131-3 reserves (the name of every
//! standard function, what their C or C++ output means already), and a generated file should pass all of them.

use crate::matiec;
use rustc_hash::FxHashSet;

/// Targets that share their reserved words.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Family {
    /// The textual languages of IEC 61131-3, all editions and dialects.
    Iec,
    /// The instruction list of IEC 61131-3, where operators are words.
    InstructionList,
    /// The statement list of STEP 7, in both its sets of mnemonics.
    StatementList,
    /// Fields, local variables and functions of Rust.
    RustValues,
    /// Types, variants and constants of Rust.
    RustTypes,
    /// Classes and local variables of JavaScript.
    JavaScript,
    /// All names of C; what is read as C++ as well.
    C,
}

/// The reserved words of a family.
#[derive(Clone)]
pub struct Reserved {
    words: FxHashSet<&'static str>,
    /// What the words end with, a bit a character: most names of charts end with a digit, and few words do.
    last: u128,
    /// What the overloaded and the converting functions begin with, and what follows: `ADD_TIME`, `INT_TO_REAL`.
    heads: FxHashSet<&'static str>,
    tails: FxHashSet<&'static str>,
    /// What the tails begin with, a bit a character: a number behind the first underscore is none.
    tail: u128,
    /// What makes an address together with a number: `M10`, `DB1`.
    addresses: FxHashSet<&'static str>,
    /// What no name may have within it behind `END_`.
    ends: &'static [&'static str],
    /// What cannot be the name of a program organisation unit.
    units: FxHashSet<&'static str>,
}

impl Reserved {
    /// The words of a family.
    pub fn of(family: Family) -> Self {
        match family {
            Family::Iec => Reserved::iec(""),
            Family::InstructionList => Reserved::iec(INSTRUCTIONS),
            Family::StatementList => Reserved {
                addresses: split(&[STL_ADDRESSES]),
                ..Reserved::words(&[STL_KEYWORDS, STL_ENGLISH, STL_GERMAN, STL_ADDRESSES])
            },
            Family::RustValues => Reserved::words(&[RUST_KEYWORDS, RUST_VALUES]),
            Family::RustTypes => Reserved::words(&[RUST_KEYWORDS, RUST_TYPES]),
            Family::JavaScript => Reserved::words(&[JS_KEYWORDS, JS_VALUES]),
            Family::C => Reserved::words(&[C_KEYWORDS, C_MACROS, C_VALUES]),
        }
    }

    fn iec(more: &'static str) -> Self {
        let tails = split(&[TYPES, "BCD TO TRUNC"]);
        Reserved {
            heads: split(&[TYPES, FUNCTIONS, OPERATORS, "BCD CTD CTU CTUD TO"]),
            tail: bits(tails.iter().filter_map(|tail| tail.bytes().next())),
            tails,
            ends: &matiec::ENDS,
            units: split(&[matiec::PINS]),
            ..Reserved::words(&[
                KEYWORDS,
                TYPES,
                FUNCTIONS,
                FUNCTION_BLOCKS,
                LATER_EDITIONS,
                DIALECTS,
                SCL,
                C_MACROS,
                more,
            ])
        }
    }

    fn words(tables: &[&'static str]) -> Self {
        let none = FxHashSet::default;
        let words = split(tables);
        let last = bits(words.iter().filter_map(|word| word.bytes().last()));
        Reserved { words, last, heads: none(), tails: none(), tail: 0, addresses: none(), ends: &[], units: none() }
    }

    /// Whether a word, in upper case, is reserved.
    pub fn contains(&self, word: &str) -> bool {
        let may_be_word = word.bytes().last().is_some_and(|byte| self.last & bit(byte) != 0);
        if may_be_word && self.words.contains(word) {
            return true;
        }
        if !self.addresses.is_empty() {
            let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
            if self.addresses.contains(letters) {
                return true;
            }
        }
        // `DATE_AND_TIME_TO_DATE`: names of types have underscores, too.
        let converts = |(from, to)| self.heads.contains(from) && self.tails.contains(to);
        let extends = |(head, tail): (&str, &str)| {
            self.heads.contains(head) && tail.split('_').all(|part| self.tails.contains(part))
        };
        // What is short is searched faster without further ado.
        let Some(joint) = word.bytes().position(|byte| byte == b'_') else { return false };
        let parts = (&word[..joint], &word[joint + 1..]);
        if parts.1.bytes().next().is_none_or(|byte| self.tail & bit(byte) == 0) {
            return false;
        }
        let to = word.as_bytes().windows(TO.len()).position(|part| part == TO.as_bytes());
        extends(parts) || to.is_some_and(|at| converts((&word[..at], &word[at + TO.len()..])))
    }

    /// Whether a word, in upper case, cannot be the name of a program organisation unit.
    pub fn contains_unit(&self, word: &str) -> bool {
        self.units.contains(word)
    }

    /// Where a name has within it what no name may have, without regard to case: the place of the underscore that holds
    /// it together.
    pub fn joint_within(&self, name: &str) -> Option<usize> {
        let name = name.as_bytes();
        let starts = |part: &[u8], word: &str| {
            part.get(..word.len()).is_some_and(|part| part.eq_ignore_ascii_case(word.as_bytes()))
        };
        let is_joint = |joint: &usize| {
            let (before, behind) = name.split_at(*joint);
            let is_end = before.last_chunk().is_some_and(|end: &[u8; 3]| end.eq_ignore_ascii_case(b"END"));
            is_end && self.ends.iter().any(|word| starts(&behind[1..], word))
        };
        (0..name.len()).filter(|at| name[*at] == b'_').find(is_joint)
    }
}

/// The bits of characters.
fn bits(bytes: impl Iterator<Item = u8>) -> u128 {
    bytes.fold(0, |bits, byte| bits | bit(byte))
}

/// The bit of a character; none of those that are not ASCII.
fn bit(byte: u8) -> u128 {
    1_u128.checked_shl(byte.into()).unwrap_or(0)
}

/// Between the types of a conversion.
const TO: &str = "_TO_";

fn split(tables: &[&'static str]) -> FxHashSet<&'static str> {
    tables.iter().flat_map(|table| table.split_ascii_whitespace()).collect()
}

/// IEC 61131-3, edition 2, annex C, and the words of instruction lists that a parser may meet in any place.
const KEYWORDS: &str = "
    ACTION AND ARRAY AT BY CASE CONFIGURATION CONSTANT DO ELSE ELSIF EN END_ACTION END_CASE END_CONFIGURATION END_FOR
    END_FUNCTION END_FUNCTION_BLOCK END_IF END_PROGRAM END_REPEAT END_RESOURCE END_STEP END_STRUCT END_TRANSITION
    END_TYPE END_VAR END_WHILE ENO EXIT FALSE FOR FROM FUNCTION FUNCTION_BLOCK F_EDGE IF INITIAL_STEP MOD NON_RETAIN NOT
    OF ON OR PROGRAM READ_ONLY READ_WRITE REPEAT RESOURCE RETAIN RETURN R_EDGE STEP STRUCT TASK THEN TO TRANSITION TRUE
    TYPE UNTIL VAR VAR_ACCESS VAR_CONFIG VAR_EXTERNAL VAR_GLOBAL VAR_INPUT VAR_IN_OUT VAR_OUTPUT VAR_TEMP WHILE WITH XOR
";

/// Operators that are functions as well: `AND_BOOL`, `MOD_INT`.
const OPERATORS: &str = "AND MOD NOT OR XOR";

/// Operators of instruction lists, those that stand for an input of a function block included.
const INSTRUCTIONS: &str = "
    ADD AND ANDN CAL CALC CALCN CD CLK CU DIV EQ GE GT IN JMP JMPC JMPCN LD LDN LE LT MOD MUL NE NOT OR ORN PT PV R R1 RET
    RETC RETCN S S1 ST STN SUB XOR XORN
";

/// Elementary and generic types, with their short names.
const TYPES: &str = "
    ANY ANY_BIT ANY_DATE ANY_DERIVED ANY_ELEMENTARY ANY_INT ANY_MAGNITUDE ANY_NUM ANY_REAL ANY_STRING BOOL BYTE CHAR
    DATE DATE_AND_TIME DINT DT DWORD INT LDATE LDT LINT LREAL LTIME LTOD LWORD REAL SINT STRING TIME TIME_OF_DAY TOD
    UDINT UINT ULINT USINT WCHAR WORD WSTRING
";

/// Standard functions.
const FUNCTIONS: &str = "
    ABS ACOS ADD ADD_DT_TIME ADD_TOD_TIME ASIN ATAN ATAN2 CONCAT CONCAT_DATE CONCAT_DATE_TOD CONCAT_DT CONCAT_TOD COS
    DAY_OF_WEEK DELETE DIV DIVTIME EQ EXP EXPT FIND GE GT INSERT IS_VALID IS_VALID_BCD LE LEFT LEN LIMIT LN LOG LT MAX MID
    MIN MOVE MUL MULTIME MUX NE REPLACE RIGHT ROL ROR SEL SHL SHR SIN SPLIT_DATE SPLIT_DT SPLIT_TOD SQRT SUB
    SUB_DATE_DATE SUB_DT_DT SUB_DT_TIME SUB_TOD_TIME SUB_TOD_TOD TAN TRUNC
";

/// Standard function blocks, and those that MATIEC brings along.
const FUNCTION_BLOCKS: &str = "
    CTD CTU CTUD DERIVATIVE F_TRIG HYSTERESIS INTEGRAL PID RAMP RS RTC R_TRIG SEMA SR TOF TON TP
";

/// What edition 3 and object-oriented dialects add.
const LATER_EDITIONS: &str = "
    ABSTRACT CLASS CONTINUE END_CLASS END_INTERFACE END_METHOD END_NAMESPACE END_PROPERTY EXTENDS FINAL IMPLEMENTS INTERFACE
    INTERNAL METHOD NAMESPACE NULL OVERLAP OVERRIDE PRIVATE PROPERTY PROTECTED PUBLIC REF REF_TO SUPER THIS USING
";

/// What CODESYS, TwinCAT and others add.
const DIALECTS: &str = "
    ADR AND_THEN BIT BITADR END_GET END_SET END_UNION GOTO INDEXOF INI JMP OR_ELSE PERSISTENT POINTER REFERENCE SIZEOF
    UNION VAR_GENERIC VAR_INST VAR_STAT XSIZEOF
";

/// What SCL adds: a `#` before a name does not make every word a name there.
const SCL: &str = "
    BEGIN BLOCK_DB BLOCK_FB BLOCK_FC CONST DATA_BLOCK END_CONST END_DATA_BLOCK END_LABEL END_ORGANIZATION_BLOCK END_REGION
    LABEL NOP ORGANIZATION_BLOCK REGION S5TIME VARIANT VOID
";

/// Words of source files of STEP 7, and its types.
const STL_KEYWORDS: &str = "
    ANY ARRAY AUTHOR BEGIN BLOCK_DB BLOCK_FB BLOCK_FC BLOCK_SDB BOOL BYTE CHAR CODE_VERSION1 COUNTER DATA_BLOCK DATE
    DATE_AND_TIME DINT DT DWORD END_DATA_BLOCK END_FUNCTION END_FUNCTION_BLOCK END_ORGANIZATION_BLOCK END_STRUCT
    END_SYSTEM_FUNCTION END_SYSTEM_FUNCTION_BLOCK END_TYPE END_VAR EN ENO FALSE FAMILY FUNCTION FUNCTION_BLOCK INT
    KNOW_HOW_PROTECT NAME NETWORK NON_RETAIN NULL OF ORGANIZATION_BLOCK POINTER READ_ONLY REAL RET_VAL S5TIME STANDARD STRING
    STRUCT SYSTEM_FUNCTION SYSTEM_FUNCTION_BLOCK TIME TIMER TIME_OF_DAY TITLE TOD TRUE TYPE UNLINKED VAR VAR_INPUT
    VAR_IN_OUT VAR_OUTPUT VAR_TEMP VERSION VOID WORD
";

/// Mnemonics of STL, the English ones; bits of the status word.
const STL_ENGLISH: &str = "
    A ABS ACOS AD AN AR1 AR2 ASIN ATAN AW BCD BE BEC BEU BLD BR BTD BTI CAD CALL CAR CAW CC CD CDB CLR COS CU DEC DTB DTR
    ENT EXP FN FP FR INC INVD INVI ITB ITD JBI JC JCB JCN JL JM JMZ JN JNB JNBI JO JP JPZ JU JUO JZ L LAR1 LAR2 LC LEAVE
    LN LOOP MCR MCRA MCRD MOD NEGD NEGI NEGR NOP NOT O OD ON OPN OS OV OW POP PUSH R RLD RLDA RND RRD RRDA S SAVE SD SE
    SET SF SIN SLD SLW SP SQR SQRT SRD SRW SS SSD SSI STW T TAK TAN TAR1 TAR2 TRUNC UC UO X XN XOD XOW
";

/// Those that the German set has for itself.
const STL_GERMAN: &str = "
    AUF BEA BEB BIE SA SI SPA SPB SPBB SPBI SPBIN SPBN SPBNB SPL SPM SPMZ SPN SPO SPP SPPZ SPS SPU SPZ SV TAD TAW TDB U UD
    UN UW ZR ZV
";

/// Memory areas and blocks, of both sets.
const STL_ADDRESSES: &str = "
    A AB AD AW B C D DB DBB DBD DBW DBX DI DIB DID DIW DIX E EB ED EW FB FC I IB ID IW L LB LD LW M MB MD MW OB P PA PAB
    PAD PAW PE PEB PED PEW PI PIB PID PIW PQ PQB PQD PQW Q QB QD QW SDB SFB SFC T UDT V VAT Z
";

/// Macros and types of the headers that C code made by MATIEC includes: its members are our names in upper case.
const C_MACROS: &str = "
    FILE
    AIO_PRIO_DELTA_MAX BC_BASE_MAX BC_DIM_MAX BC_SCALE_MAX BC_STRING_MAX BIG_ENDIAN BUFSIZ BYTE_ORDER
    CHARCLASS_NAME_MAX CHAR_BIT CHAR_MAX CHAR_MIN CLOCKS_PER_SEC CLOCK_BOOTTIME CLOCK_BOOTTIME_ALARM
    CLOCK_MONOTONIC CLOCK_MONOTONIC_COARSE CLOCK_MONOTONIC_RAW CLOCK_PROCESS_CPUTIME_ID CLOCK_REALTIME
    CLOCK_REALTIME_ALARM CLOCK_REALTIME_COARSE CLOCK_TAI CLOCK_THREAD_CPUTIME_ID COLL_WEIGHTS_MAX DBG DBG_TYPE
    DBL_DECIMAL_DIG DBL_DIG DBL_EPSILON DBL_HAS_SUBNORM DBL_MANT_DIG DBL_MAX DBL_MAX_10_EXP DBL_MAX_EXP DBL_MIN
    DBL_MIN_10_EXP DBL_MIN_EXP DBL_TRUE_MIN DECIMAL_DIG DELAYTIMER_MAX EN_ENO EN_ENO_PARAMS EOF EPOCH_YEAR
    EXIT_FAILURE EXIT_SUCCESS EXPR_NEST_MAX FD_CLR FD_ISSET FD_SET FD_SETSIZE FD_ZERO FILENAME_MAX FLT_DECIMAL_DIG
    FLT_DIG FLT_EPSILON FLT_EVAL_METHOD FLT_HAS_SUBNORM FLT_MANT_DIG FLT_MAX FLT_MAX_10_EXP FLT_MAX_EXP FLT_MIN
    FLT_MIN_10_EXP FLT_MIN_EXP FLT_RADIX FLT_ROUNDS FLT_TRUE_MIN FOPEN_MAX FP_ILOGB0 FP_ILOGBNAN FP_INFINITE FP_NAN
    FP_NORMAL FP_SUBNORMAL FP_ZERO HOST_NAME_MAX HUGE_VAL HUGE_VALF HUGE_VALL IEC_TYPES_ALL_H IEC_TYPES_H INFINITY
    INT16_C INT16_MAX INT16_MIN INT32_C INT32_MAX INT32_MIN INT64_C INT64_MAX INT64_MIN INT8_C INT8_MAX INT8_MIN
    INTMAX_C INTMAX_MAX INTMAX_MIN INTPTR_MAX INTPTR_MIN INT_FAST16_MAX INT_FAST16_MIN INT_FAST32_MAX
    INT_FAST32_MIN INT_FAST64_MAX INT_FAST64_MIN INT_FAST8_MAX INT_FAST8_MIN INT_LEAST16_MAX INT_LEAST16_MIN
    INT_LEAST32_MAX INT_LEAST32_MIN INT_LEAST64_MAX INT_LEAST64_MIN INT_LEAST8_MAX INT_LEAST8_MIN INT_MAX INT_MIN
    LDBL_DECIMAL_DIG LDBL_DIG LDBL_EPSILON LDBL_HAS_SUBNORM LDBL_MANT_DIG LDBL_MAX LDBL_MAX_10_EXP LDBL_MAX_EXP
    LDBL_MIN LDBL_MIN_10_EXP LDBL_MIN_EXP LDBL_TRUE_MIN LINE_MAX LITTLE_ENDIAN LLONG_MAX LLONG_MIN LOGIN_NAME_MAX
    LONG_MAX LONG_MIN MATH_ERREXCEPT MATH_ERRNO MAX_CANON MAX_INPUT MB_CUR_MAX MB_LEN_MAX MQ_PRIO_MAX M_1_PI M_2_PI
    M_2_SQRTPI M_E M_LN10 M_LN2 M_LOG10E M_LOG2E M_PI M_PI_2 M_PI_4 M_SQRT1_2 M_SQRT2 NAME_MAX NAN NFDBITS
    NGROUPS_MAX PATH_MAX PDP_ENDIAN PIPE_BUF PTHREAD_DESTRUCTOR_ITERATIONS PTHREAD_KEYS_MAX PTHREAD_STACK_MIN
    PTRDIFF_MAX PTRDIFF_MIN RAND_MAX RE_DUP_MAX RTSIG_MAX SCHAR_MAX SCHAR_MIN SECONDS_PER_DAY SECONDS_PER_HOUR
    SECONDS_PER_MINUTE SEEK_CUR SEEK_END SEEK_SET SEM_VALUE_MAX SHRT_MAX SHRT_MIN SIG_ATOMIC_MAX SIG_ATOMIC_MIN
    SIZE_MAX SSIZE_MAX STR_LEN_TYPE STR_MAX_LEN TEST_EN TEST_EN_COND TIMER_ABSTIME TIME_UTC TMP_MAX TTY_NAME_MAX
    UCHAR_MAX UINT16_C UINT16_MAX UINT32_C UINT32_MAX UINT64_C UINT64_MAX UINT8_C UINT8_MAX UINTMAX_C UINTMAX_MAX
    UINTPTR_MAX UINT_FAST16_MAX UINT_FAST32_MAX UINT_FAST64_MAX UINT_FAST8_MAX UINT_LEAST16_MAX UINT_LEAST32_MAX
    UINT_LEAST64_MAX UINT_LEAST8_MAX UINT_MAX ULLONG_MAX ULONG_MAX USHRT_MAX VA_ARGS_BOOL VA_ARGS_BYTE VA_ARGS_DATE
    VA_ARGS_DINT VA_ARGS_DT VA_ARGS_DWORD VA_ARGS_INT VA_ARGS_LINT VA_ARGS_LREAL VA_ARGS_LWORD VA_ARGS_REAL
    VA_ARGS_SINT VA_ARGS_STRING VA_ARGS_TIME VA_ARGS_TOD VA_ARGS_UDINT VA_ARGS_UINT VA_ARGS_ULINT VA_ARGS_USINT
    VA_ARGS_WORD VA_ARGS_WSTRING WCHAR_MAX WCHAR_MIN WCONTINUED WEXITED WEXITSTATUS WIFCONTINUED WIFEXITED
    WIFSIGNALED WIFSTOPPED WINT_MAX WINT_MIN WNOHANG WNOWAIT WSTOPPED WSTOPSIG WTERMSIG WUNTRACED XATTR_LIST_MAX
    XATTR_NAME_MAX XATTR_SIZE_MAX
";

/// Keywords of Rust, strict and reserved, of all editions.
const RUST_KEYWORDS: &str = "
    ABSTRACT AS ASYNC AWAIT BECOME BOX BREAK CONST CONTINUE CRATE DO DYN ELSE ENUM EXTERN FALSE FINAL FN FOR GEN IF IMPL IN
    LET LOOP MACRO MATCH MOD MOVE MUT OVERRIDE PRIV PUB REF RETURN SELF STATIC STRUCT SUPER TRAIT TRUE TRY TYPE TYPEOF
    UNION UNSAFE UNSIZED USE VIRTUAL WHERE WHILE YIELD
";

/// What generated Rust calls its own fields and parameters, and what it calls by a plain name.
const RUST_VALUES: &str = "
    ACTIVE BYTES CORE DIVIDE FLAGS FROM INPUT INPUTS NOW OUT OUTPUTS REMAINDER RUNTIME SITUATION STEP TIMER VALUES VARIABLES
";

/// What generated Rust calls its own types, and the prelude.
const RUST_TYPES: &str = "
    ALL ASREF ASMUT BOOL CHART CLONE COPY DEBUG DEFAULT DOUBLEENDEDITERATOR DROP EQ ERR EXACTSIZEITERATOR EXTEND F32 F64
    FINGERPRINT FLAGS FNMUT FNONCE FROM FROMITERATOR FUTURE I16 I32 I64 INPUTS INTO INTOFUTURE INTOITERATOR ITERATOR NONE
    NUMBER OK OPTION ORD OUTPUTS PARTIALEQ PARTIALORD RESTORER RESULT RETAINED RETAINED_LEN SAVED SAVED_LEN SAVER SEND SIZED
    SOME STEP STR STRING
    SYNC TIMER TOOWNED TOSTRING TRYFROM TRYINTO U16 U32 U64 U8 UNPIN USIZE VALUES VARIABLES VEC
";

/// ECMAScript 2024, strict mode and modules: keywords, words reserved for later, and what means something everywhere.
const JS_KEYWORDS: &str = "
    ARGUMENTS AS ASYNC AWAIT BREAK CASE CATCH CLASS CONST CONTINUE DEBUGGER DEFAULT DELETE DO ELSE ENUM EVAL EXPORT EXTENDS
    FALSE FINALLY FOR FROM FUNCTION GET IF IMPLEMENTS IMPORT IN INFINITY INSTANCEOF INTERFACE LET META NAN NEW NULL OF
    PACKAGE PRIVATE PROTECTED PUBLIC RETURN SET STATIC SUPER SWITCH TARGET THIS THROW TRUE TRY TYPEOF UNDEFINED VAR VOID
    WHILE WITH YIELD
";

/// What a module uses and declares itself, and the types beside it.
const JS_VALUES: &str = "
    ACCEPTED ACTIONS ASSERTED FOLLOWING NAMES ACTIVE ANY ARRAY BEGIN BIGINT BOOLEAN CHART CLOCK CONSTANTS DELAY DELAYS DINT END ERROR FLAGS FORCED
    FRESH FROZEN FULL HASRUN INPUTS INT JSON KEPT M MATH MICROSTEP NEVER NOW NUMBER OBJECT ORDERS OUTPUTS PARTIAL PLAIN
    PROGRAM PUT RANGEERROR RANGES REAL RECORD RESTORED RESTORING RUN SAVED SEAL SEEN SHOWN SITUATION STRING SYMBOL TIME
    TRANSITIONS TYPEERROR UDINT UINT UNKNOWN VARIABLES WANTED
";

/// C99 to C23 and C++: keywords, and what macros of `<stdbool.h>` and `<stdint.h>` and of compilers mean.
const C_KEYWORDS: &str = "
    ALIGNAS ALIGNOF AND AND_EQ ASM AUTO BITAND BITOR BOOL BREAK CASE CATCH CHAR CHAR16_T CHAR32_T CHAR8_T CLASS COMPL CONCEPT
    CONST CONSTEVAL CONSTEXPR CONSTINIT CONST_CAST CONTINUE CO_AWAIT CO_RETURN CO_YIELD DECLTYPE DEFAULT DELETE DO DOUBLE
    DYNAMIC_CAST ELSE ENUM EXPLICIT EXPORT EXTERN FALSE FLOAT FOR FRIEND GOTO IF INLINE INT INT16_C INT16_MAX INT16_MIN
    INT16_T INT32_C INT32_MAX INT32_MIN INT32_T INT64_C INT64_MAX INT64_MIN INT64_T INT8_C INT8_MAX INT8_MIN INT8_T LINUX
    LONG MUTABLE NAMESPACE NEW NOEXCEPT NOT NOT_EQ NULL NULLPTR OPERATOR OR OR_EQ PRIVATE PROTECTED PUBLIC REGISTER
    REINTERPRET_CAST REQUIRES RESTRICT RETURN SHORT SIGNED SIZEOF STATIC STATIC_ASSERT STATIC_CAST STRUCT SWITCH TEMPLATE
    THIS THREAD_LOCAL THROW TRUE TRY TYPEDEF TYPEID TYPENAME TYPEOF TYPEOF_UNQUAL UINT16_C UINT16_MAX UINT16_T UINT32_C
    UINT32_MAX UINT32_T UINT64_C UINT64_MAX UINT64_T UINT8_C UINT8_MAX UINT8_T UNION UNIX UNSIGNED USING VIRTUAL VOID
    VOLATILE WCHAR_T WHILE XOR XOR_EQ
";

/// What generated C calls its own.
const C_VALUES: &str = "
    ADD_DINT ADD_INT ADD_TIME ADD_UINT AT BITS_OF_LREAL BITS_OF_REAL BYTES CHART CHECKSUM CLEAR_FLAGS DELAY DELAY_HAS_RUN
    DELAY_RUN DIV_DINT DIV_INT DIV_TIME DIV_UINT FINGERPRINT FLAGS H INIT INIT_INPUTS INPUTS IS_ACTIVE IS_POSSIBLE IS_RIGHT KEPT LREAL_OF_BITS
    MUL_DINT MUL_INT MUL_TIME MUL_UINT NEG_DINT NEG_INT NEG_TIME NEG_UDINT NEG_UINT NOW_MS OUT OUTPUTS PUT PUT_STATE REAL_OF_BITS REM_DINT REM_INT
    REM_TIME REM_UINT RESTART RESTORE RESTORED_DELAY RESTORING SAVE SAVED_LEN SCAN SEALED SETS STEP STEP_COUNT STEP_LABEL
    SUB_DINT SUB_INT SUB_TIME SUB_UINT TAKE TAKE_BOOL TAKEN TO_DINT TO_INT TO_TIME TO_UINT VALUE VARIABLES
";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_upper_case_identifiers() {
        let families =
            [Family::Iec, Family::InstructionList, Family::StatementList, Family::RustValues, Family::RustTypes];
        for word in families.into_iter().flat_map(|family| Reserved::of(family).words) {
            assert!(word.chars().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_'), "{word}");
        }
    }

    #[test]
    fn forms() {
        let reserved = Reserved::of(Family::Iec);
        for word in [
            "INT_TO_REAL",
            "TIME_TO_DINT",
            "TO_INT",
            "ADD_TIME",
            "MUX_INT_BOOL",
            "REAL_TRUNC_INT",
            "CTU_DINT",
            "MOD_INT",
            "AND_BOOL",
            "DATE_AND_TIME_TO_DATE",
            "DATE_AND_TIME_TO_TIME_OF_DAY",
        ] {
            assert!(reserved.contains(word), "{word}");
        }
        for word in ["TIME_LEFT", "INT_TO_EXT", "X_TO_Y", "DATE_1", "ADD_TIME_2", "ADD_", "X1", ""] {
            assert!(!reserved.contains(word), "{word}");
        }
    }
}
