"""Compiles sketches as another core than AVR's does, with its oddities: check.py compiler options...

Examples must pass without a warning, and what cannot work must say so in one error.
"""

import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
FIRMWARE = HERE.parents[2] / 'javino-firmware'
CORE = HERE.parents[1] / 'arm' / 'core'

ODD = ['-DCORE_WITHOUT_ROOM', '-DCORE_HAS_USB', '-DEEPROM_SIZE=256', '-funsigned-char']
WITH_EEPROM = ['-I', CORE / 'EEPROM']

STATION = '''#include <JavinoBDI.h>
JavinoSerialRadio radio(Serial1, JAVINO_HC_12);
JavinoRadioBoard board(Serial, "station 1.0", radio);
'''
AT_SERIAL1 = '''#include <JavinoBDI.h>
JavinoBoard board(Serial1, "lamp 1.0");
'''
RELAY = '''#include <JavinoBDI.h>
JavinoSerialRadio radio(Serial1, JAVINO_E32);
JavinoRelay relay(radio);
JavinoBroadcaster broadcaster(radio);
'''


def example(name):
    return f'#include "{FIRMWARE}/examples/{name}/{name}.ino"\n'


# Sketch, its core, and words of the one error that it gives.
SKETCHES = [
    *((example(name), options, []) for name in ('01_Blink', '03_Thermometer', '11_OwnRadio', '12_OwnEeprom')
      for options in (ODD, ['-DCORE_TELLS_NO_ROOM'], WITH_EEPROM)),
    (AT_SERIAL1, ODD, []),
    (RELAY, ODD, []),
    ('#include <EEPROM.h>\n' + STATION, WITH_EEPROM, []),
    ('#include <EEPROM.h>\n#include <Javino.h>\n' + STATION, WITH_EEPROM, []),
    (STATION, ODD, ['#include <EEPROM.h>', 'JavinoEeprom', 'OwnEeprom']),
    ('#include <EEPROM.h>\n' + STATION, [*WITH_EEPROM, '-DE2END=255'], ['no room for keys']),
    ('#include <JavinoBDI.h>\nJavinoAskRadio radio;\n', ODD, ['this chip has no timer and pins for it']),
    ('#include <JavinoBDI.h>\nJavinoAskRadio radio(11, 12, 2000, 1);\n', ODD, ['this chip has no timer and pins for it']),
]

failed = 0
for sketch, options, words in SKETCHES:
    command = [*sys.argv[1:], '-I', CORE, *options, '-I', FIRMWARE / 'src', '-include', 'Arduino.h', '-fsyntax-only',
               '-x', 'c++', '-']
    said = subprocess.run(command, input=sketch, text=True, stderr=subprocess.PIPE).stderr
    errors = [line for line in said.splitlines() if 'error:' in line]
    if len(errors) != (1 if words else 0) or not all(word in errors[0] for word in words):
        failed += 1
        print(f'{sketch}with {options} gives {len(errors)} errors instead of {words}:\n{said}')
print(f'{len(SKETCHES)} sketches, {failed} failed')
sys.exit(failed != 0)
