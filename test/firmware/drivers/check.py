"""Boards over JavinoRadioHead in RadioHead's own simulator: check.py RadioHead's folder, node.

Each board is a process, and the simulator is the air: it delays packets by their length, and loses those that collide. No test
of time: a busy machine may delay processes, so what was not delivered, or a broadcast that was not heard, is sent again.
"""

import pathlib
import queue
import socket
import subprocess
import sys
import tempfile
import threading
import time

SIMULATOR = pathlib.Path(sys.argv[1]) / 'tools' / 'etherSimulator.pl'
NODE = sys.argv[2]
TRIES = 8
SECONDS = 20  # for each
processes = []


class Node:
    def __init__(self, port, number, name, rate):
        self.process = start([NODE, f'127.0.0.1:{port}', str(number), name, str(rate)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                             text=True)
        self.lines = queue.Queue()
        threading.Thread(target=lambda: [self.lines.put(line.rstrip('\n')) for line in self.process.stdout], daemon=True).start()
        if not self.says('ready'):
            sys.exit(f'{name} does not start')

    def says(self, *expected):
        """Whether one of these lines comes. @return which"""
        end = time.monotonic() + SECONDS
        while time.monotonic() < end:
            try:
                line = self.lines.get(timeout=end - time.monotonic())
            except queue.Empty:
                return None
            if line in expected:
                return line
        return None

    def send(self, to, text):
        self.process.stdin.write(f'{to} {text}\n')
        self.process.stdin.flush()


def start(command, **options):
    processes.append(subprocess.Popen(command, **options))
    return processes[-1]


def connects(port):
    with socket.socket() as client:
        return client.connect_ex(('127.0.0.1', port)) == 0


def check(name, tries):
    """Fails if none of some tries succeeds."""
    if not any(tries):
        sys.exit(f'{name}: none of {TRIES} tries succeeded')
    print(name, flush=True)


def unicasts(sender, receiver, text):
    for number in range(TRIES):
        sender.send('SUPO', f'tell;{text}{number}')
        yield sender.says('delivered', 'undelivered') == 'delivered' and receiver.says(f'ROMA to SUPO: tell;{text}{number}')


def broadcasts(sender, receiver, text):
    for number in range(TRIES):
        sender.send('////', f'tell;{text}{number}')
        yield sender.says('sent') and receiver.says(f'ROMA to ////: tell;{text}{number}')


def scenario(config, with_relay, rate):
    """@param rate of the air, in bit/s"""
    with socket.socket() as free:
        free.bind(('127.0.0.1', 0))
        port = free.getsockname()[1]
    with tempfile.NamedTemporaryFile('w') as file:
        file.write(config)
        file.flush()
        simulator = start(['perl', SIMULATOR, '-c', file.name, '-p', str(port), '-b', str(rate)])
        while not connects(port):
            if simulator.poll() is not None:
                sys.exit("RadioHead's simulator does not start; it needs libpoe-perl")
            time.sleep(0.05)
    if with_relay:
        Node(port, 3, 'relay', rate)
    return Node(port, 1, 'ROMA', rate), Node(port, 2, 'SUPO', rate)


try:
    near = scenario('', False, 50000)
    check('a sealed unicast', unicasts(*near, 'near'))
    check('one of three packets', unicasts(*near, 'x' * 150))
    check('a broadcast', broadcasts(*near, 'near'))
    far = scenario('probability:1:2:0.0\n', True, 10000)
    check('a sealed unicast through a relay', unicasts(*far, 'far'))
    check('a broadcast through a relay', broadcasts(*far, 'far'))
    check('a sealed unicast at 300 bit/s', unicasts(*scenario('', False, 300), 'slow'))
finally:
    for process in reversed(processes):
        process.kill()
        process.wait()
