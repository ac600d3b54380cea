// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware.h"

#include <elf.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>

// The low bits of an AVR ELF's flags name the family; 6 has a 22-bit program counter, as the
// ATmega2560 (binutils, include/elf/avr.h).
#define AVR_FAMILY_MASK 0x7F
#define AVR_FAMILY_6 6

// Why the header is not that of an ELF file for our chip, or NULL.
static const char *header_mistake(const Elf32_Ehdr *header, size_t length)
{
    if (length != sizeof *header || memcmp(header->e_ident, ELFMAG, SELFMAG) != 0)
        return "is no ELF file; expected the .elf that the AVR compiler writes, not the .hex";
    if (header->e_ident[EI_CLASS] != ELFCLASS32 || header->e_machine != EM_AVR)
        return "is built for another processor; expected one for the ATmega2560";
    if ((header->e_flags & AVR_FAMILY_MASK) != AVR_FAMILY_6)
        return "is built for another AVR; expected one for the ATmega2560 (-mmcu=atmega2560)";
    return NULL;
}

static int check_header(const char *path, char *error, size_t error_size)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        snprintf(error, error_size, "%s: %s", path, strerror(errno));
        return -1;
    }
    Elf32_Ehdr header;
    size_t length = fread(&header, 1, sizeof header, file);
    fclose(file);
    const char *mistake = header_mistake(&header, length);
    if (mistake)
        snprintf(error, error_size, "%s %s", path, mistake);
    return mistake ? -1 : 0;
}

static void release(elf_firmware_t *elf)
{
    for (uint32_t i = 0; i < elf->symbolcount; i++)
        free(elf->symbol[i]);
    free(elf->symbol);
    free(elf->flash);
    free(elf->eeprom);
    free(elf->fuse);
    free(elf->lockbits);
}

int firmware_load(struct avr_t *avr, const char *path, char *error, size_t error_size)
{
    elf_firmware_t elf;
    if (check_header(path, error, error_size) != 0)
        return -1;
    memset(&elf, 0, sizeof elf);
    if (elf_read_firmware(path, &elf) != 0 || elf.flashsize == 0 ||
        elf.flashbase + elf.flashsize > avr->flashend + 1) {
        snprintf(error, error_size, "%s holds no program that fits the ATmega2560's flash", path);
        release(&elf);
        return -1;
    }
    // Supply and clock are those of the board, whatever the file says.
    elf.frequency = elf.vcc = elf.avcc = elf.aref = 0;
    avr_load_firmware(avr, &elf);
    release(&elf);
    return 0;
}
