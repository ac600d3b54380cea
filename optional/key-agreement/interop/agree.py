"""Agrees by EDHOC with lakers, an implementation that shares nothing with ours, as often as is said, in both roles.

gradle :key-agreement:lakers -Ppython=PYTHON, of a PYTHON that has lakers-python (PyPI). Arguments: a class path, and how often.
"""

import pathlib
import subprocess
import sys

import lakers

TRACE = pathlib.Path(__file__).parent.parent / "src/test/resources/keyagreement/edhoc/rfc9529.properties"
# Beyond 23, lakers 0.6.2 encodes labels in a way of its own.
LABEL = 23
VALUES = {
    name.strip(): bytes.fromhex(value)
    for name, value in (line.split("=") for line in TRACE.read_text().splitlines() if "=" in line)
}


class Ours:
    """Our side, in a process of Java."""

    def __init__(self, class_path):
        command = ["java", "-cp", class_path, "keyagreement.edhoc.Speaker"]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)

    def say(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def hear(self):
        return bytes.fromhex(self.process.stdout.readline())

    def end(self):
        self.process.stdin.close()
        self.process.wait()


def respond(ours):
    """Lakers answers what we begin."""
    ours.say("initiator")
    theirs = lakers.EdhocResponder(VALUES["r"], VALUES["cred_r"])
    theirs.process_message_1(ours.hear())
    ours.say(theirs.prepare_message_2(lakers.CredentialTransfer.ByReference, None, None).hex())
    kid, _ = theirs.parse_message_3(ours.hear())
    theirs.verify_message_3(lakers.credential_check_or_fetch(kid, VALUES["cred_i"]))
    theirs.completed_without_message_4()
    return theirs


def initiate(ours):
    """Lakers begins, and we answer."""
    ours.say("responder")
    theirs = lakers.EdhocInitiator()
    ours.say(theirs.prepare_message_1(None, None).hex())
    _, kid, _ = theirs.parse_message_2(ours.hear())
    theirs.verify_message_2(VALUES["i"], VALUES["cred_i"], lakers.credential_check_or_fetch(kid, VALUES["cred_r"]))
    message_3, _ = theirs.prepare_message_3(lakers.CredentialTransfer.ByReference, None)
    ours.say(message_3.hex())
    theirs.completed_without_message_4()
    return theirs


def main(class_path, times):
    ours = Ours(class_path)
    for role in (respond, initiate):
        for _ in range(int(times)):
            theirs = role(ours)
            exported = theirs.edhoc_exporter(0, [], 16) + theirs.edhoc_exporter(LABEL, [1, 2, 3], 100)
            assert ours.hear() == bytes(exported), "other keys"
            theirs.edhoc_key_update(list(VALUES["update"]))
            assert ours.hear() == bytes(theirs.edhoc_exporter(0, [], 16)), "other keys after the update"
        print(f"{times} of {times}: {role.__doc__}")
    ours.end()


if __name__ == "__main__":
    main(*sys.argv[1:])
