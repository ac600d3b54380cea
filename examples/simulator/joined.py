#!/usr/bin/env python3
"""Joins emulated boards to a simulator of the world: the simulator moves the robot, the boards' sketches steer it.

    joined.py EMULATOR SCENARIO.json

Written as a controller for Webots (https://cyberbotics.com): `Robot` is Webots' own class where Webots runs this file,
and where it does not, the small world below that can do the same: a robot on a road, and a wall before it.
"""

import json
import socket
import subprocess
import sys
import tempfile
import threading
import time

BOARD = "robot"
STEP_MS = 20
MOTOR_SPEED = 6.0  # rad/s


class EmulatedBoards:
    """The emulator as a simulator sees it: it is told what sensors measure, and asked which pins are high."""

    def __init__(self, emulator, scenario):
        path = tempfile.mkdtemp() + "/control"
        self.process = subprocess.Popen([emulator, scenario, "--trace", "-", "--control", path],
                                        stdout=subprocess.PIPE, text=True)
        self.pins = {}
        threading.Thread(target=self._read_trace, daemon=True).start()
        self.control = socket.socket(socket.AF_UNIX)
        while self.control.connect_ex(path) != 0:
            if self.process.poll() is not None:
                sys.exit("joined: the emulator has ended; it says why above")
            time.sleep(0.05)
        self.replies = self.control.makefile("r")

    def _read_trace(self):
        for line in self.process.stdout:
            event = json.loads(line)
            if event["event"] == "pin":
                self.pins[event["board"], event["name"]] = event["level"] == 1

    def is_high(self, board, name):
        """Whether a pin that the scenario watches under this name is high."""
        return self.pins.get((board, name), False)

    def command(self, **command):
        """A command of the emulator's README; ends the program where the emulator refuses it."""
        self.control.sendall(json.dumps(command).encode() + b"\n")
        reply = json.loads(self.replies.readline() or '{"error": "the emulator has ended"}')
        if "error" in reply:
            sys.exit("joined: " + reply["error"])


try:
    from controller import Robot
except ImportError:

    class Robot:
        """The part of Webots' Robot, its motors and its distance sensor that this file needs."""

        def __init__(self):
            self.velocity = 0.0
            self.to_wall = 1.5  # m
            self.steps_end = time.monotonic()

        def getDevice(self, name):
            return self

        def setPosition(self, position):
            pass

        def setVelocity(self, velocity):
            self.velocity = velocity

        def enable(self, period):
            pass

        def getValue(self):
            return self.to_wall

        def step(self, milliseconds):
            self.to_wall = max(0.0, self.to_wall - 0.05 * self.velocity * milliseconds / 1000)
            self.steps_end += milliseconds / 1000
            time.sleep(max(0.0, self.steps_end - time.monotonic()))
            return 0


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: joined.py EMULATOR SCENARIO.json")
    boards = EmulatedBoards(sys.argv[1], sys.argv[2])
    robot = Robot()
    sonar = robot.getDevice("sonar")
    sonar.enable(STEP_MS)
    wheels = [robot.getDevice(name) for name in ("left wheel", "right wheel")]
    for wheel in wheels:
        wheel.setPosition(float("inf"))
    while robot.step(STEP_MS) != -1:
        boards.command(do="sensor", board=BOARD, pin=2, value=min(400.0, 100 * sonar.getValue()))
        for wheel in wheels:
            wheel.setVelocity(MOTOR_SPEED if boards.is_high(BOARD, "motor") else 0.0)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
