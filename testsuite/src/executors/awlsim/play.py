"""Plays charts as STL in awlsim, scan by scan.

The argument is a file of JSON: a list of jobs, each with the text of its source (FB 1, DB 1), the names and types of its
inputs, a row of their values a call, and what is read after each call: a name, a type, and a number if it is asked whether
the variable has that value. What is printed is a line a call: the job's number, the row, and the values.

A source that has an OB 1 of its own is given bytes of the process image instead, and so many output bytes are read.
"""

import json
import struct
import sys

# The simulator comes first: its parts import each other in a circle.
from awlsim.core.main import AwlSim
from awlsim.core.memory import AwlMemoryObject_asScalar, make_AwlMemoryObject_fromScalar
from awlsim.awlcompiler.tokenizer import AwlParser

CALLER = "ORGANIZATION_BLOCK OB 1\nBEGIN\n  CALL FB 1, DB 1;\nEND_ORGANIZATION_BLOCK\n"

BITS = {"BOOL": 1, "INT": 16, "WORD": 16, "DINT": 32, "DWORD": 32, "REAL": 32, "TIME": 32}
SIGNED = {"INT", "DINT", "TIME"}


def raw(value, kind):
    """A number as the bits of its type."""
    if kind == "REAL":
        return struct.unpack(">I", struct.pack(">f", value))[0]
    return int(value) & ((1 << BITS[kind]) - 1)


def cooked(bits, kind):
    """The bits of a type as a word to print."""
    if kind == "REAL":
        return "%.9g" % struct.unpack(">f", struct.pack(">I", bits))[0]
    if kind in SIGNED and bits >> (BITS[kind] - 1):
        bits -= 1 << BITS[kind]
    return str(bits)


def load(text, caller, accumulators):
    """A simulator with a source in it, of a CPU with two accumulators (S7-300) or four (S7-400), and the CPU."""
    sim = AwlSim()
    cpu = sim.getCPU()
    cpu.setCycleTimeLimit(3600.0)
    cpu.getSpecs().setNrAccus(accumulators)
    for part in filter(None, (text, caller)):
        parser = AwlParser()
        parser.parseText(part)
        sim.load(parser.getParseTree())
    sim.build()
    return sim, cpu


def play(job, out):
    sim, cpu = load(job["text"], CALLER, 2 + 2 * (job["index"] % 2))
    data = cpu.getDB(1).structInstance
    sim.startup()
    for row, values in enumerate(job["rows"]):
        for (name, kind), value in zip(job["inputs"], values):
            data.setFieldDataByName(name, make_AwlMemoryObject_fromScalar(raw(value, kind), BITS[kind]))
        sim.runCycle()
        words = [str(job["index"]), str(row)]
        for name, kind, equals in job["reads"]:
            word = cooked(AwlMemoryObject_asScalar(data.getFieldDataByName(name)), kind)
            words.append(word if equals is None else str(int(word == str(equals))))
        out.write(" ".join(words) + "\n")


def play_image(job, out):
    sim, cpu = load(job["text"], "", 2)
    sim.startup()
    for row, values in enumerate(job["image"]):
        for place, value in enumerate(values):
            cpu.storeInputByte(place, value)
        sim.runCycle()
        words = [job["index"], row] + [cpu.fetchOutputByte(place) for place in range(job["bytes"])]
        out.write(" ".join(map(str, words)) + "\n")


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        jobs = json.load(file)
    for job in jobs:
        (play_image if "image" in job else play)(job, sys.stdout)


main()
