"""Counts the deepest stack of programs for an ATmega328P, from their disassembly: stack.py program.elf...

The deepest chain of calls from main, and the deepest interrupt on top of it: interrupts do not interrupt each other. Calls by
a pointer are those of a radio; the functions of a sketch that the library calls are not counted, as they take their part
of what is left.
"""

import bisect
import re
import subprocess
import sys

RETURN_ADDRESS = 2
SAVED_BY_PROLOGUE = 18  # registers that gcc's __prologue_saves__ can push
RAM = 2048


def functions(program):
    """@return for each function its instructions, as (operation, operands, target's function, offset in it)."""
    text = subprocess.run(['avr-objdump', '-d', program], capture_output=True, text=True, check=True).stdout
    bodies, starts, name = {}, {}, None
    for line in text.splitlines():
        if match := re.match(r'^([0-9a-f]+) <(.+)>:$', line):
            starts[int(match[1], 16)] = name = match[2]
            bodies[name] = []
        elif name and (match := re.match(r'^\s*[0-9a-f]+:\t(?:[0-9a-f]{2} )+\s*\t(\S+)\s*([^;]*)(?:; (0x[0-9a-f]+))?', line)):
            bodies[name].append((match[1], match[2].strip(), match[3]))
    addresses = sorted(starts)

    def resolve(operation, operands, comment):
        at = comment or (operands if operands.startswith('0x') else None)
        if at is None or not re.match(r'r?call|r?jmp|br', operation):
            return operation, operands, None, 0
        start = addresses[bisect.bisect_right(addresses, int(at, 16)) - 1]
        return operation, operands, starts[start], int(at, 16) - start

    return {name: [resolve(*each) for each in body] for name, body in bodies.items()}


def frame_and_calls(name, body):
    """@return the bytes that a function puts on the stack, the functions that it calls, and those that it ends in."""
    depth, frame, constants, calls, ends = 0, 0, {}, set(), set()
    for index, (operation, operands, target, offset) in enumerate(body):
        reads_pointer = any(each[0] == 'in' and each[1].startswith('r28, 0x3d') for each in body[max(0, index - 3):index])
        if operation == 'ldi':
            register, value = operands.split(', ')
            constants[register] = int(value, 16)
        elif operation == 'push':
            depth += 1
        elif operation in ('sbiw', 'subi') and operands.startswith('r28') and reads_pointer:
            frame = int(operands.split(', ')[1], 16)
        elif operation == 'rcall' and operands.startswith('.+0'):  # room on the stack
            depth += RETURN_ADDRESS
        elif operation in ('call', 'rcall'):
            calls.add(target)
        elif operation == 'icall':
            calls.add('a radio')
        elif target == '__prologue_saves__':
            depth += SAVED_BY_PROLOGUE - offset // 2
            frame = constants['r26'] | constants['r27'] << 8
        elif target not in (None, name, '__epilogue_restores__'):
            ends.add(target)
    return depth + frame, calls, ends


def deepest(name, parts, known):
    """@return the most bytes that a function and what it calls put on the stack, and the functions that do."""
    if name == 'a radio':
        radio = [each for each in parts if re.match(r'_ZNK?9javinolib8AskRadio', each)]
        return max((deepest(each, parts, known) for each in radio), default=(0, []))
    if name not in known:
        known[name] = (0, [])  # no function calls itself
        frame, calls, ends = parts[name]
        ways = [(frame, [])]
        for call in calls:
            depth, path = deepest(call, parts, known)
            ways.append((frame + RETURN_ADDRESS + depth, path))
        ways += [deepest(end, parts, known) for end in ends]
        depth, path = max(ways, key=lambda way: way[0])
        known[name] = depth, [f'{frame:4} {name}'] + path
    return known[name]


for program in sys.argv[1:]:
    parts = {name: frame_and_calls(name, body) for name, body in functions(program).items()}
    known = {}
    main, path = deepest('main', parts, known)
    interrupt, onTop = max(deepest(name, parts, known) for name in parts if re.match(r'__vector_\d', name))
    stack = RETURN_ADDRESS + main + RETURN_ADDRESS + interrupt
    fields = subprocess.run(['avr-size', program], capture_output=True, text=True, check=True).stdout.split()
    static = int(fields[7]) + int(fields[8])
    print(f'{program.split("/")[-1]}: stack {stack} bytes, static RAM {static}, left {RAM - stack - static}')
    demangled = subprocess.run(['c++filt'], input='\n'.join(path + ['on top'] + onTop), capture_output=True, text=True, check=True)
    print(re.sub(r'\.lto_priv\S*|\.constprop\S*', '', demangled.stdout))
