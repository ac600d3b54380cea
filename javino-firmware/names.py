"""Fails if src/support/SketchMacros.inc does not have each name in the headers that a sketch includes.

names.py --write mends it, names.py --macros prints a macro of each name, for tests.
"""

import pathlib
import re
import sys

SOURCES = pathlib.Path(__file__).parent / 'src'
LIST = SOURCES / 'support' / 'SketchMacros.inc'
COLUMNS = 120

KEYWORDS = set('''alignas alignof asm auto bool break case catch char class const const_cast constexpr continue decltype default
    define defined delete do double dynamic_cast elif else endif enum error explicit export extern false final float for friend
    goto if ifdef ifndef include inline int long mutable namespace new noexcept nullptr operator override pragma private
    protected public register reinterpret_cast return short signed sizeof static static_assert static_cast struct switch
    template this thread_local throw true try typedef typeid typename undef union unsigned using virtual void volatile wchar_t
    while'''.split()) - {'error', 'define', 'include', 'final'}

# Names that the headers use as a macro of Arduino's core or of avr-libc, or that are one on some cores.
USED = set('''ARDUINO ARDUINO_ARCH_AVR E2END EEPROM F F_CPU GPIOR0 GPIOR1 GPIOR2 ISR ISR_ALIASOF MAPPED_EEPROM_SIZE OCIE0B
    OCR0B OCR3BL OCR4BL OCR5BL PCICR RAMEND Serial TCCR0A TIMER0_COMPB_vect TIMER1_COMPC_vect TIMSK0 WGM00 WGM01
    clockCyclesPerMicrosecond pgm_read_byte pgm_read_word'''.split())

# Of ESP32s, and of the standard library.
USED |= set('ESP32 ESP8266 IRAM_ATTR UINT8_MAX UINT16_MAX UINT32_MAX'.split())

# Macros by which AskRadio.h knows other libraries.
USED |= set('Servo_h TimerOne_h_ IR_USE_AVR_TIMER1 IR_USE_AVR_TIMER3 IR_USE_AVR_TIMER4 IR_USE_AVR_TIMER5'.split())


def headers(path, found):
    """Adds a header and all that it includes of the library."""
    path = path.resolve()
    if path in found or path.suffix not in ('.h', '.def'):
        return
    found[path] = path.read_text()
    for name in re.findall(r'#include "([^"]+)"', found[path]):
        headers(path.parent / name, found)


def names():
    """@return the names that a macro of a sketch may have, in order: all but the library's own, which have a prefix."""
    found = {}
    for header in ('JavinoBDI.h', 'Javino.h', 'JavinoRadioHead.h', 'JavinoRadioLib.h'):
        headers(SOURCES / header, found)
    words = set()
    for text in found.values():
        for noise in (r'/\*.*?\*/', r'//[^\n]*', r'#include[^\n]*', r'"(?:\\.|[^"\\])*"', r"'(?:\\.|[^'\\])*'"):
            text = re.sub(noise, '', text, flags=re.DOTALL)
        words.update(re.findall(r'\b[A-Za-z]\w*', text))
    return sorted(word for word in words - KEYWORDS - USED if not re.match(r'(?i)javino|radiolib_|\w+_t?$', word))


def rows():
    row = ''
    for name in names():
        entry = f'  DO({name})' if row == '' else f' DO({name})'
        if len(row) + len(entry) > COLUMNS - 2:
            yield row
            row = f'  DO({name})'
        else:
            row += entry
    yield row


def text():
    return '\n'.join([
        '// The names in the headers that a sketch includes, written by names.py. A macro of a sketch that has one of them is set',
        '// aside here, for the header to bring it back at its end.',
        '',
        '#ifndef JAVINO_MACROS_ARE_ASIDE',
        '#define JAVINO_MACROS_ARE_ASIDE',
        '#define JAVINO_EACH_NAME(DO) \\',
        ' \\\n'.join(rows()),
        '',
        '#define JAVINO_PRAGMA(text) _Pragma(#text)',
        '#define JAVINO_SET_ASIDE(name) JAVINO_PRAGMA(push_macro(#name))',
        '#define JAVINO_BRING_BACK(name) JAVINO_PRAGMA(pop_macro(#name))',
        '',
        'JAVINO_EACH_NAME(JAVINO_SET_ASIDE)',
        *(f'#undef {name}' for name in names()),
        '#endif',
        ''])


if __name__ == '__main__':
    if sys.argv[1:] == ['--write']:
        LIST.write_text(text())
    elif sys.argv[1:] == ['--macros']:
        for number, name in enumerate(names()):
            print(f'#undef {name}\n#define {name} {1000 + number}')
    elif not LIST.exists() or LIST.read_text() != text():
        sys.exit(f'{LIST} lacks names of the headers, or has others: run javino-firmware/names.py --write')
