"""Links AES of one profile of sizes with what was compiled for another: check.py compiler options...

A build may give the profile to one of C++ and assembly alone. Such a program must not link, as it would compute wrongly.
"""

import pathlib
import subprocess
import sys
import tempfile

CRYPTO = pathlib.Path(__file__).parents[3] / 'javino-firmware' / 'src' / 'crypto'
PRIMITIVES = [CRYPTO / name for name in ('Aes128Avr.S', 'Aes128AvrSmall.S', 'Aes128Portable.cpp')]
PROFILES = {'large': [], 'small': ['-DJAVINO_SMALL']}

CALLER = '''#include "Aes128.h"
#include "../support/Wipe.cpp"
uint8_t key[16], block[16];
int main() { javinolib::Aes128(key).encrypt(block); }
'''


def call(*arguments, **more):
    command = [*sys.argv[1:], *map(str, arguments)]
    return subprocess.run(command, text=True, capture_output=True, **more)


failed = []
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    for profile, options in PROFILES.items():
        own = folder / profile
        own.mkdir()
        call('-c', *options, *PRIMITIVES, cwd=own, check=True)
        call('-c', *options, CRYPTO / 'Aes128.cpp', '-o', own / 'class.o', check=True)
        call('-c', *options, '-I', CRYPTO, '-o', own / 'caller.o', '-x', 'c++', '-', input=CALLER, check=True)
    for ours in PROFILES:
        for theirs in PROFILES:
            objects = [folder / ours / 'caller.o', folder / ours / 'class.o',
                       *(folder / theirs / (source.stem + '.o') for source in PRIMITIVES)]
            linked = call(*objects, '-o', folder / 'program')
            if (linked.returncode == 0) != (ours == theirs):
                failed.append(f'C++ of the {ours} profile with AES of the {theirs} one: {linked.stderr or "linked"}')
sys.exit('\n'.join(failed) or 0)
