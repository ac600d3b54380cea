"""Compiles sketches with a name that is no F("…"): each is one error, which says so: check.py compiler options..."""

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

PERCEPTS = ['percepts.add("dark")', 'percepts.add("light", 5)', 'percepts.add("light", 5, 4)', 'percepts.add("celsius", 20.5)',
            'percepts.add("celsius", 20.5, 0.5, 1000)', 'percepts.add("says", "hello")', 'percepts.add("says", F("hello"))',
            'percepts.event("pressed", true)']
ACTIONS = ['board.action("lampOn", lampOn)', 'board.action("lampOn", [](const JavinoArguments &) { return true; })']
RIGHT = 'percepts.add(F("light"), 5)', 'board.action(F("lampOn"), lampOn)'


def errors(percept, action):
    command = [*sys.argv[1:], '-I', SOURCES, '-S', '-o', '/dev/null', '-x', 'c++', '-']
    compiled = subprocess.run(command, input=SKETCH % (percept, action), text=True, capture_output=True)
    return [line for line in compiled.stderr.splitlines() if 'error: ' in line]


failed = []
if errors(*RIGHT):
    failed.append(f'{RIGHT}: {errors(*RIGHT)}')
for wrong in [(percept, RIGHT[1]) for percept in PERCEPTS] + [(RIGHT[0], action) for action in ACTIONS]:
    said = errors(*wrong)
    if len(said) != 1 or 'F("' not in said[0]:
        failed.append(f'{wrong}: {said}')
sys.exit('\n'.join(failed) or 0)
