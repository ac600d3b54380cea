#!/usr/bin/env bash
# Installs what Javino is built and run with, from Debian's own packages. Does nothing where all is there.
# --run-only: what agents need on the small computer that they run on, to which a PC's builds are copied.
set -euo pipefail

# package                what it is for (a|b: the first that this system has)
PACKAGES="
openjdk-17-jdk-headless|openjdk-21-jdk-headless|openjdk-25-jdk-headless  Java: the library, the agent architecture, the tests
gradle                   the build
gcc-avr                  compiler for the boards
avr-libc                 C library for the boards
arduino-core-avr         Arduino core
arduino-builder          builds sketches
gcc                      the emulator
g++                      attacks on the firmware, on the PC
make                     drives both
cmake                    configures both
libsimavr-dev            AVR emulation
libelf-dev               reads firmware files
libjansson-dev           JSON: scenario files and test vectors
libgtest-dev             GoogleTest
libgmock-dev             GoogleMock
clang                    tests and fuzzes C and C++ with sanitizers, on the PC
libclang-rt-dev          its sanitizers and fuzzer
git                      a test asks it which files it ignores
procps                   ends what Gradle has started, at Ctrl-C
clang-format             holds the style of C and C++
mosquitto                the MQTT broker of the gateways' tests
mosquitto-clients        what such a broker tells
openssl                  certificates for it
socat                    a page's commands to the emulator
tshark                   the tests of captures, and of the dissector for Wireshark
python3                  the second checker of the models
asciidoctor              the manual's pages, in Debian's package
gpg                      signs releases
gpg-agent                keeps its keys
chromium                 the tests of the live page
chromium-driver          drives it
fonts-dejavu-core        letters for it
"
# For systems without these packages: the commands that must be there (a|b: one of them).
COMMANDS="javac gradle avr-gcc arduino-cli|arduino-builder gcc g++ make cmake clang++ clang-format"

case "${1-}" in
    "") ;;
    --run-only)
        PACKAGES="
openjdk-17-jre-headless|openjdk-21-jre-headless|openjdk-25-jre-headless  Java: the agents
avrdude                  flashes sketches
"
        COMMANDS="java avrdude" ;;
    *) echo "usage: ./setup.sh [--run-only]" >&2; exit 2 ;;
esac

say() { printf 'setup: %s\n' "$*"; }

# Whether that command, java or javac, is there and of Java 17 or newer.
has_java() {
    command -v "$1" >/dev/null || return 1
    local version
    version=$("$1" -version 2>&1 | sed -n 's/^\(javac\|.* version\) "\{0,1\}\([0-9]*\).*/\2/p')
    [ "${version:-0}" -ge 17 ]
}

installed() {
    case $1 in
        openjdk-*-jdk-headless) has_java javac ;;
        openjdk-*-jre-headless) has_java java ;;
        gradle) command -v gradle >/dev/null ;;
        *) [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ] ;;
    esac
}

# The first of "a|b" that this system has; of those that it does not know, a.
first_known() {
    local package
    for package in ${1//|/ }; do
        apt-cache show "$package" >/dev/null 2>&1 && { echo "$package"; return; }
    done
    echo "${1%%|*}"
}

on_another_system() {
    say "this is no Debian system; Javino needs these (Debian's names):"
    printf '%s\n' "$PACKAGES" | sed '/^$/d; s/^/    /'
    local missing=""
    for command in $COMMANDS; do
        command -v ${command//|/ } >/dev/null || missing+=" $command"
    done
    [ -z "$missing" ] && { say "all commands that it calls are on the path"; return 0; }
    say "not on the path:$missing"
    return 1
}

command -v apt-get >/dev/null && command -v dpkg-query >/dev/null || { on_another_system; exit; }

missing=()
for package in $(printf '%s\n' "$PACKAGES" | awk '{print $1}'); do
    installed "$package" || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
    say "everything is installed"
    exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
        say "run as root, or install sudo: apt-get install $(for package in "${missing[@]}"; do first_known "$package"; done | xargs)"
        exit 1
    }
    as_root=(sudo)
fi
export DEBIAN_FRONTEND=noninteractive
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# The output of apt is shown only if it fails.
apt() {
    "${as_root[@]}" apt-get "$@" >"$log" 2>&1 && return
    tail -n 20 "$log" >&2
    say "apt-get $1 has failed; its last lines are above" >&2
    exit 1
}
apt update -qq
for i in "${!missing[@]}"; do missing[i]=$(first_known "${missing[i]}"); done
say "installing ${missing[*]}"
apt install -y -qq --no-install-recommends "${missing[@]}"
say "done"
