// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware.h"

#include <elf.h>
#include <errno.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <simavr/sim_hex.h>

// The bits of an AVR ELF's flags that name the family (binutils, include/elf/avr.h).
#define AVR_FAMILY_MASK 0x7F

// Checks that the header is that of an ELF file for the model's chip.
static int check_header(const Elf32_Ehdr *header, size_t length, const model *m, const char *path, char *error,
                        size_t error_size)
{
    if (length != sizeof *header || memcmp(header->e_ident, ELFMAG, SELFMAG) != 0)
        snprintf(error, error_size, "%s is no ELF file; expected the .elf that the AVR compiler writes, not the .hex",
                 path);
    else if (header->e_ident[EI_CLASS] != ELFCLASS32 || header->e_machine != EM_AVR)
        snprintf(error, error_size, "%s is built for another processor; expected one for the %s", path, m->chip);
    else if ((header->e_flags & AVR_FAMILY_MASK) != m->family)
        snprintf(error, error_size, "%s is built for another AVR; expected one for the %s (-mmcu=%s), the model \"%s\"",
                 path, m->chip, m->mcu, m->name);
    else
        return 0;
    return -1;
}

static int check_file(const model *m, const char *path, char *error, size_t error_size)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        snprintf(error, error_size, "%s: %s", path, strerror(errno));
        return -1;
    }
    Elf32_Ehdr header;
    size_t length = fread(&header, 1, sizeof header, file);
    fclose(file);
    return check_header(&header, length, m, path, error, error_size);
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

int firmware_load(struct avr_t *avr, const model *m, const char *path, char *error, size_t error_size)
{
    elf_firmware_t elf;
    if (check_file(m, path, error, error_size) != 0)
        return -1;
    memset(&elf, 0, sizeof elf);
    if (elf_read_firmware(path, &elf) != 0 || elf.flashsize == 0 ||
        elf.flashbase + elf.flashsize > avr->flashend + 1) {
        snprintf(error, error_size, "%s holds no program that fits the %s's flash", path, m->chip);
        release(&elf);
        return -1;
    }
    // Supply and clock are those of the board, whatever the file says.
    elf.frequency = elf.vcc = elf.avcc = elf.aref = 0;
    avr_load_firmware(avr, &elf);
    release(&elf);
    return 0;
}

static bool in_boot_section(const struct avr_t *avr, const model *m, const ihex_chunk_t *chunk)
{
    uint32_t end = avr->flashend + 1;
    return chunk->baseaddr >= end - m->boot_size && chunk->baseaddr < end && chunk->size <= end - chunk->baseaddr;
}

int firmware_add_boot_loader(struct avr_t *avr, const model *m, const char *path, char *error, size_t error_size)
{
    ihex_chunk_p chunks = NULL;
    int count = read_ihex_chunks(path, &chunks);
    bool fits = count > 0;
    for (int i = 0; i < count; i++)
        fits = fits && in_boot_section(avr, m, &chunks[i]);
    for (int i = 0; fits && i < count; i++) {
        memcpy(avr->flash + chunks[i].baseaddr, chunks[i].data, chunks[i].size);
        if (i == 0 || chunks[i].baseaddr < avr->reset_pc)
            avr->reset_pc = chunks[i].baseaddr;
    }
    if (fits)
        avr->codeend = avr->flashend;
    else
        snprintf(error, error_size, "%s holds no boot loader for the %s; expected Intel HEX in the last %u bytes of its"
                                    " flash", path, m->chip, m->boot_size);
    if (chunks)
        free_ihex_chunks(chunks);
    return fits ? 0 : -1;
}
