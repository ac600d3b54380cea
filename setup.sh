#!/usr/bin/env bash
# Installs what Javino is built and run with, from Debian's own packages. Does nothing where all is there.
set -euo pipefail

# package                what it is for
PACKAGES="
openjdk-17-jdk-headless  Java: the library, the agent architecture, the tests
gradle                   the build
gcc-avr                  compiler for the boards
avr-libc                 C library for the boards
arduino-core-avr         Arduino core
arduino-builder          builds sketches
gcc                      the emulator
g++                      firmware tests on the PC
make                     drives both
cmake                    configures both
libsimavr-dev            AVR emulation
libelf-dev               reads firmware files
pkg-config               finds these libraries
libjansson-dev           JSON: scenario files and test vectors
libgtest-dev             GoogleTest
libgmock-dev             GoogleMock
clang                    fuzzes the firmware's code on the PC
libclang-rt-dev          its fuzzer and sanitizers
spin                     checks the model beside our checker
"
# For systems without these packages: the commands that must be there.
COMMANDS="javac gradle avr-gcc arduino-builder gcc g++ make cmake clang++"

say() { printf 'setup: %s\n' "$*"; }

has_jdk() { command -v javac >/dev/null && [ "$(javac -version 2>&1 | sed 's/[^0-9]*\([0-9]*\).*/\1/')" -ge 17 ]; }

installed() {
    case $1 in
        openjdk-17-jdk-headless) has_jdk ;;
        gradle) command -v gradle >/dev/null ;;
        *) [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ] ;;
    esac
}

on_another_system() {
    say "this is no Debian system; Javino needs these (Debian's names):"
    printf '%s\n' "$PACKAGES" | sed '/^$/d; s/^/    /'
    local missing=""
    for command in $COMMANDS; do
        command -v "$command" >/dev/null || missing+=" $command"
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
    command -v sudo >/dev/null || { say "run as root, or install sudo: apt-get install ${missing[*]}"; exit 1; }
    as_root=(sudo)
fi
say "installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
say "done"
