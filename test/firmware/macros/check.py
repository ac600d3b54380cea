"""Compiles the headers that a sketch includes behind macros of all names that it may have: check.py compiler options...

These are the names in usual.txt, which sketches often have, and all in the headers. All must be there afterwards as before.
"""

import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
FIRMWARE = HERE.parents[2] / 'javino-firmware'
sys.path.insert(0, str(FIRMWARE))
sys.dont_write_bytecode = True

import names  # noqa: E402

usual = (HERE / 'usual.txt').read_text().split()
macros = sorted({*usual, *names.names()})
lines = ['#include <Arduino.h>']
for number, macro in enumerate(macros):
    lines += [f'#undef {macro}', f'#define {macro} {1000 + number}']
lines += ['#include <JavinoBDI.h>', '#include <Javino.h>']
for number, macro in enumerate(macros):
    lines += [f'#if {macro} != {1000 + number}', f'#error {macro} is not what it was', '#endif']
command = [*sys.argv[1:], '-I', FIRMWARE / 'src', '-fsyntax-only', '-x', 'c++', '-']
compiled = subprocess.run(command, input='\n'.join(lines) + '\n', text=True)
print(f'{len(usual)} usual names, {len(macros)} in all')
sys.exit(compiled.returncode)
