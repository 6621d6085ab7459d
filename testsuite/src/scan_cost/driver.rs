//! The C program that times one spelling.
//!
//! The block is called through a pointer that the C compiler cannot see through, as a PLC's runtime calls a program: so
//! the call is not inlined, and the same loop around a function that does nothing is what has to be subtracted. A scan that
//! clears costs the driver an input a ring that is set and taken back. Time is that of the process, not of the clock on the
//! wall, and of some short slices the least counts. Before anything is timed, the outputs are compared with the inputs
//! given, around the rings and a bit further.

use crate::rings::Rings;
use std::fmt::Write as _;

/// Slices of a millisecond or two in which a program times one thing.
const SLICES: u32 = 8;

const HEAD: &str = "\
#include <stdio.h>
#include <time.h>
#include \"iec_std_lib.h\"
TIME __CURRENT_TIME;
BOOL __DEBUG;
#include \"POUS.h\"
#include \"POUS.c\"
";

const BODY: &str = "\
static void nothing(BLOCK *block) {}
static void (*volatile scan)(BLOCK *);
static long at;

static void idle(long scans) {
  while (scans--) scan(&d);
}

/* The input that leaves the active step of each ring. */
static void put(BOOL value) {
  long ring;
  for (ring = 0; ring < RINGS; ring++) *input[ring * LENGTH + at] = value;
}

static void clearing(long scans) {
  while (scans--) {
    put(1);
    scan(&d);
    put(0);
    at = at + 1 == LENGTH ? 0 : at + 1;
  }
}

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return t.tv_sec * 1e9 + t.tv_nsec;
}

static double timed(void (*what)(long), long scans) {
  double begin = now();
  what(scans);
  return now() - begin;
}

/* Ns a scan: the least of some short slices, because all that comes in between makes a slice longer. */
static double least(void (*what)(long), void (*block)(BLOCK *)) {
  long scans = 1;
  int slice;
  double best;
  scan = block;
  while ((best = timed(what, scans)) < 1e6) scans *= 2;
  for (slice = 0; slice < SLICES; slice++) {
    double taken = timed(what, scans);
    if (taken < best) best = taken;
  }
  return best / scans;
}

static double cost(void (*what)(long)) {
  double all = least(what, BODY);
  /* The empty loop must not move the step that the block is at. */
  long before = at;
  double loop = least(what, nothing);
  at = before;
  return all - loop;
}

static int only(long step) {
  long i;
  for (i = 0; i < STEPS; i++)
    if (*output[i] != (i % LENGTH == step)) return 0;
  return 1;
}

int main(void) {
  long done;
  INIT(&d, 0);
  scan = BODY;
  idle(2);
  for (done = 0; done < 2 * LENGTH + 1; done++) {
    if (!only(at)) {
      fprintf(stderr, \"after %ld clearings, other outputs than those of step %ld of each ring\\n\", done, at);
      return 1;
    }
    clearing(1);
    idle(1);
  }
  printf(\"%.4f\", cost(idle));
  printf(\" %.4f %lu\\n\", cost(clearing), (unsigned long)sizeof d);
  return 0;
}
";

/// The C program for the function block of a name.
pub(super) fn write(block: &str, rings: Rings) -> String {
    let block = block.to_uppercase();
    let mut out = HEAD.to_owned();
    let _ = writeln!(out, "#define STEPS {}L\n#define RINGS {}L", rings.steps, rings.tokens);
    let _ = writeln!(out, "#define LENGTH {}L\n#define SLICES {SLICES}", rings.length());
    let _ = writeln!(out, "typedef {block} BLOCK;\n#define INIT {block}_init__\n#define BODY {block}_body__");
    out.push_str("static BLOCK d;\n");
    for (name, letter) in [("input", 'X'), ("output", 'W')] {
        let _ = writeln!(out, "static BOOL *const {name}[STEPS] = {{");
        for i in 0..rings.steps {
            let _ = writeln!(out, "  &d.{letter}_{i}.value,");
        }
        out.push_str("};\n");
    }
    out.push_str(BODY);
    out
}
