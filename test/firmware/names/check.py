"""Compiles sketches with a name that is no F("…"), with the radio of the published library, and on an AVR one with a memory for
keys: each is one error, which says so:
check.py compiler options..."""

import pathlib
import subprocess
import sys

SOURCES = pathlib.Path(__file__).parents[3] / 'javino-firmware' / 'src'

SKETCH = '''#include <Arduino.h>
#include <JavinoBDI.h>

JavinoBoard board(Serial, "lamp 1.0");

bool lampOn(const JavinoArguments &) { return true; }

void perceive(JavinoPercepts &percepts) {
  %s;
}

void setup() {
  board.onPercepts(perceive);
  %s;
}
'''

OWN_MEMORY = '''#include <Arduino.h>
#include <JavinoBDI.h>

class Memory : public JavinoEeprom {
  uint8_t read(uint16_t) override { return 0; }
  void write(uint16_t, uint8_t) override {}
};

Memory memory;
JavinoAskRadio radio;
%s board(Serial, "station 1.0", radio, memory);

void setup() { board.begin(115200); }
'''

PUBLISHED = '''#include <Javino.h>

Javino javino;

void setup() {
  javino.setId("ROMA");
  javino.start(9600);
}

void loop() { %s; }
'''

RADIO = [('javino.enableRF(12, 11)', 'JavinoRadioBoard board('), ('javino.setCipherKey("0123456789abcdef")', 'javino provision'),
         ('javino.sendMsgRF("help")', '.diffuse('), ('javino.sendMsgRF("ROMA", "help")', '.diffuse('),
         ('if (javino.availableMsgRF()) javino.run()', '.getRFMessages(open)'),
         ('javino.buffer2USB()', '.getRFMessages(open)')]

PERCEPTS = ['percepts.add("dark")', 'percepts.add("light", 5)', 'percepts.add("light", 5, 4)', 'percepts.add("celsius", 20.5)',
            'percepts.add("celsius", 20.5, 0.5, 1000)', 'percepts.add("says", "hello")', 'percepts.add("says", F("hello"))',
            'percepts.add("light", 5, 4, 500, 1)', 'percepts.event("pressed", true)']
ACTIONS = ['board.action("lampOn", lampOn)', 'board.action("lampOn", [](const JavinoArguments &) { return true; })']
RIGHT = 'percepts.add(F("light"), 5)', 'board.action(F("lampOn"), lampOn)'


def errors(sketch):
    command = [*sys.argv[1:], '-I', SOURCES, '-S', '-o', '/dev/null', '-x', 'c++', '-']
    compiled = subprocess.run(command, input=sketch, text=True, capture_output=True)
    return [line for line in compiled.stderr.splitlines() if 'error: ' in line]


failed = []
for right in (SKETCH % RIGHT, PUBLISHED % 'javino.run()'):
    if errors(right):
        failed.append(f'{right}: {errors(right)}')
wrongs = [(wrong, SKETCH % wrong, 'F("')
          for wrong in [(percept, RIGHT[1]) for percept in PERCEPTS] + [(RIGHT[0], action) for action in ACTIONS]]
wrongs += [(call, PUBLISHED % call, words) for call, words in RADIO]
if any(option.startswith('-mmcu=') for option in sys.argv):
    wrongs += [(board, OWN_MEMORY % board, "leave out the board's fourth argument")
               for board in ('JavinoRadioBoard', 'JavinoUnicastBoard')]
for wrong, sketch, words in wrongs:
    said = errors(sketch)
    if len(said) != 1 or words not in said[0]:
        failed.append(f'{wrong}: {said}')
sys.exit('\n'.join(failed) or 0)
