#!/usr/bin/env python3
"""Measures how well test:firmware's suites kill mutants of the firmware: builds one at a time without
sanitizers, runs the suites until one fails, and writes the score into docs/results.md and the survivors into build/results.

usage: mutate.py [--mutants N|all] [--seed N]
       mutate.py --list   prints all mutants, a JSON object a line, with some more kinds, and tries none
"""
import argparse
import json
import os
import random
import re
import shutil
import subprocess
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
WORK = os.path.join(HERE, 'build', 'mutants')
TREE = os.path.join(WORK, 'tree')
OUT = os.path.join(WORK, 'out')
RESULTS = os.path.join(ROOT, 'test', 'harness', 'src', 'main', 'java', 'harness', 'Results.java')
SECTION = 'mutants of the firmware'

SOURCES = 'javino-firmware/src'
FOLDERS = ['delivery', 'radio', 'secure', 'storage']
SUITES = {'radio': ['radio/radio-tests', 'firmware-tests', 'small-tests', 'arduino-tests']}
OTHER_SUITES = ['firmware-tests', 'small-tests', 'arduino-tests', 'radio/radio-tests']
# Why a mutant does no harm that a test could see, by its changed line.
HARMLESS = {
    'symbol_ = symbolAt((0 + 1));': 'the same: the first six symbols are all training',
    'for (uint8_t i = 0; i <= READINGS; i++) storeSeals(crc, rightSeals(crc));': 'one reading more than needed',
    'if (order >= 0) waiting = LATER;': 'the same: the line before returns where it is 0',
    'periods_ = (0 + 1);': 'a carrier is taken for one a period earlier, once after a silence',
    'const bool first = recordAt(place, 0).erase((0 + 1));': 'one byte more is erased of what goes',
    'random_.seed(address_.value(), (0 + 1));': 'any number does: the addresses tell boards apart',
}
LONGEST_SECONDS = 600  # of one suite: a mutant that never ends is killed too

SWAPS = [('==', '!='), ('!=', '=='), ('<', '<='), ('<=', '<'), ('>', '>='), ('>=', '>'), ('&&', '||'), ('||', '&&'),
         ('+', '-'), ('-', '+'), ('&', '|'), ('|', '&'), ('<<', '>>'), ('>>', '<<'), ('%', '/'), ('*', '+'),
         ('+=', '-='), ('-=', '+='), ('|=', '&='), ('&=', '|=')]
STATEMENT = re.compile(r'^\s+(?:if \(.*\) )?([\w.\[\]>()-]+(?:\+\+|--)|\+\+\w+|--\w+|[\w.\[\]>-]+ [-+|&]?= .*|[\w.]+\(.*\));$')


def mutants_of(line, more=False):
    """Each mutant of one line, as (what, line); with more, numbers become smaller and double too."""
    code = line.split('//')[0].rstrip()
    if not code.strip() or re.match(r'\s*(#|static_assert|namespace|const \w+ \w+::|using|///)', code) or '__asm__' in code:
        return
    for old, new in SWAPS:
        for match in re.finditer(r'(?<=[\w)\]] )%s(?= [\w(!~*-])' % re.escape(old), code):
            yield '%s for %s' % (new, old), line[:match.start()] + new + line[match.end():]
    for match in re.finditer(r'(?<![\w.])(\d+|0x[0-9A-Fa-f]+)(?![\w.])', code):
        for change in ['+ 1', '- 1', '* 2'] if more and int(match.group(), 0) > 1 else ['+ 1']:
            mutant = '%s %s' % (match.group(), change)
            yield mutant, line[:match.start()] + '(%s)' % mutant + line[match.end():]
    for old, new in (('true', 'false'), ('false', 'true')):
        for match in re.finditer(r'\b%s\b' % old, code):
            yield '%s for %s' % (new, old), line[:match.start()] + new + line[match.end():]
    for match in re.finditer(r'(?<=[(\s])!(?=[\w(])', code):
        yield 'no !', line[:match.start()] + line[match.end():]
    match = re.match(r'(\s*(?:} else )?if )(\(.*\))( \{| return.*;| continue;| break;)$', code)
    if match:
        yield 'condition negated', match.group(1) + '(!' + match.group(2) + ')' + match.group(3)
    match = STATEMENT.match(code)
    if match and not re.match(r'\s*(const|return|static|\w+ \w+ =)', code):
        yield 'statement removed', line[:match.start(1)] + '{' + '}' + line[match.end(1) + 1:]


def all_mutants(more=False):
    for folder in FOLDERS:
        place = os.path.join(ROOT, SOURCES, folder)
        for name in sorted(os.listdir(place)):
            if not name.endswith('.cpp') or 'Avr' in name:
                continue
            with open(os.path.join(place, name)) as source:
                for number, line in enumerate(source.read().split('\n')):
                    for what, mutant in mutants_of(line, more):
                        yield folder, '%s/%s' % (folder, name), number, what, mutant


def run(command, seconds=None):
    """Whether a command succeeds, in time."""
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=seconds,
                              env=dict(os.environ, GTEST_FAIL_FAST='1', GTEST_BRIEF='1')).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def build(target='all'):
    return run(['cmake', '--build', OUT, '--parallel', '2', '--target', os.path.basename(target)])


def prepare():
    """A copy of what is tested, and a build of it that passes; @return the seconds that each suite takes."""
    ignore = shutil.ignore_patterns('build')
    shutil.rmtree(TREE, ignore_errors=True)
    shutil.rmtree(OUT, ignore_errors=True)
    for folder in ['javino-firmware/src', 'javino-firmware/examples', 'test/firmware', 'test/arduino-mock', 'test/vectors']:
        shutil.copytree(os.path.join(ROOT, folder), os.path.join(TREE, folder), ignore=ignore)
    if not run(['cmake', '-S', os.path.join(TREE, 'test/firmware'), '-B', OUT, '-DSANITIZE=OFF']) or not build():
        raise SystemExit('the firmware does not build unchanged: run gradle :test:firmware:test')
    seconds = {}
    for suite in OTHER_SUITES:
        begin = time.monotonic()
        if not run([os.path.join(OUT, suite)], LONGEST_SECONDS):
            raise SystemExit('%s fails for the unchanged firmware: run gradle :test:firmware:test' % suite)
        seconds[suite] = time.monotonic() - begin
    return seconds


def survives(mutant, seconds):
    """Whether no suite kills a mutant; None where the compiler does."""
    folder, name, number, _, line = mutant
    path = os.path.join(TREE, SOURCES, name)
    with open(path) as source:
        right = source.read()
    lines = right.split('\n')
    lines[number] = line
    try:
        with open(path, 'w') as source:
            source.write('\n'.join(lines))
        for suite in SUITES.get(folder, OTHER_SUITES):  # each is linked only if those before it have passed
            if not build(suite):
                return None
            if not run([os.path.join(OUT, suite)], min(LONGEST_SECONDS, 30 + 5 * seconds[suite])):
                return False
        return True
    finally:
        with open(path, 'w') as source:
            source.write(right)


def write(total, seed, tried, survivors):
    killed = len(tried) - len(survivors)
    scores = []
    rows = ['| folder | mutants | killed |', '| --- | --- | --- |']
    for folder in FOLDERS + [None]:
        of = [m for m in tried if folder in (m[0], None)]
        left = [m for m in survivors if folder in (m[0], None)]
        if of:
            scores.append(100 * (len(of) - len(left)) // len(of))
            rows.append('| %s | %d | %d %% |' % (folder or 'all', len(of), scores[-1]))
    text = ['- killed: **%d %% of %d** (of a folder: %d…%d %%)' % (scores[-1], len(tried), min(scores), max(scores)), '',
            'Of %d possible mutants of %s (a negated condition, another operator, a constant plus one, a removed statement)'
            ' %d that compile without a warning were tested by test:firmware\'s suites without sanitizers: %d killed.'
            % (total, ', '.join('`src/%s`' % folder for folder in FOLDERS), len(tried), killed), ''] + rows
    if survivors:
        text += ['', 'Survivors:', '', '| place | mutant | changed line | harmless, since |', '| --- | --- | --- | --- |']
        text += ['| %s:%d | %s | `%s` | %s |' % (m[1], m[2] + 1, m[3].replace('|', '\\|'), m[4].strip().replace('|', '\\|'),
                                              HARMLESS.get(m[4].strip(), ''))
                 for m in sorted(survivors)]
    run = '`gradle :test:firmware:mutation -Pmutants=%s -Pseed=%d`' % (len(tried), seed)
    subprocess.run(['java', RESULTS, ROOT, SECTION, run], input='\n'.join(text), encoding='utf-8', check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('--mutants', default='300', help='how many, or all')
    parser.add_argument('--seed', type=int, default=1, help='which ones')
    parser.add_argument('--list', action='store_true', help='print all')
    arguments = parser.parse_args()
    if arguments.list:
        for _, name, number, what, line in all_mutants(more=True):
            with open(os.path.join(ROOT, SOURCES, name)) as source:
                right = source.read().split('\n')[number]
            print(json.dumps({'file': name, 'line': number + 1, 'right': right, 'what': what, 'wrong': line}))
        return
    possible = list(all_mutants())
    chosen = list(possible)
    random.Random(arguments.seed).shuffle(chosen)
    wanted = len(chosen) if arguments.mutants == 'all' else int(arguments.mutants)
    seconds = prepare()
    tried, survivors = [], []
    try:
        for mutant in chosen:
            if len(tried) == wanted:
                break
            survived = survives(mutant, seconds)
            if survived is None:
                continue
            tried.append(mutant)
            if survived:
                survivors.append(mutant)
            print('%4d %-8s %s:%d %s' % (len(tried), 'SURVIVES' if survived else 'caught', mutant[1], mutant[2] + 1,
                                         mutant[3]), flush=True)
    finally:  # what was found counts, however it ends
        if tried:
            write(len(possible), arguments.seed, tried, survivors)


main()
