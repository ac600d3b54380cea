// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware.h"

#include <elf.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <simavr/avr_eeprom.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_hex.h>

#include "eeprom_file.h"
#include "whole_file.h"

// The bits of an AVR ELF's flags that name the family (binutils, include/elf/avr.h).
#define AVR_FAMILY_MASK 0x7F

// The addresses from which the AVR linker puts all that is not in flash: data space, and in it the EEPROM.
#define DATA_SPACE 0x800000
#define EEPROM_SPACE 0x810000

// An ELF file, all of it. Nothing in it is trusted: a file that is cut off or damaged is refused.
typedef whole_file elf_file;

// Checks that the header is that of an ELF file for the model's chip.
static int check_header(const elf_file *elf, const Elf32_Ehdr *header, const model *m, const char *path, char *error,
                        size_t error_size) {
  if (elf->length < sizeof *header || memcmp(header->e_ident, ELFMAG, SELFMAG) != 0)
    snprintf(error, error_size, "%s is no ELF file; expected the .elf that the AVR compiler writes, not the .hex",
             path);
  else if (header->e_ident[EI_CLASS] != ELFCLASS32 || header->e_ident[EI_DATA] != ELFDATA2LSB ||
           header->e_machine != EM_AVR)
    snprintf(error, error_size, "%s is built for another processor; expected one for the %s", path, m->chip);
  else if ((header->e_flags & AVR_FAMILY_MASK) != m->family)
    snprintf(error, error_size, "%s is built for another AVR; expected one for the %s (-mmcu=%s), the model \"%s\"",
             path, m->chip, m->mcu, m->name);
  else
    return 0;
  return -1;
}

// Copies a segment to `base` + `at` of a memory of `size` bytes, if it and its bytes in the file are where they can be.
static bool copy_segment(const elf_file *elf, const Elf32_Phdr *segment, uint8_t *base, uint32_t at, uint32_t size) {
  bool in_file = segment->p_offset <= elf->length && segment->p_filesz <= elf->length - segment->p_offset;
  if (!in_file || at > size || segment->p_filesz > size - at) return false;
  memcpy(base + at, elf->bytes + segment->p_offset, segment->p_filesz);
  return true;
}

// Loads what is for the flash, with the initial values of data behind the code, or for the EEPROM. All else (fuses, what
// simavr itself would take from a program, such as orders to write traces to files) is left out.
static bool load_segment(struct avr_t *avr, const model *m, const elf_file *elf, const Elf32_Phdr *segment) {
  uint8_t eeprom[MAX_EEPROM_SIZE];
  uint32_t eeprom_size = (uint32_t)m->eeprom_size;
  if (segment->p_type != PT_LOAD || segment->p_filesz == 0) return true;
  if (segment->p_paddr < DATA_SPACE) {
    bool fits = copy_segment(elf, segment, avr->flash, segment->p_paddr, avr->flashend + 1);
    uint32_t end = segment->p_paddr + segment->p_filesz;
    if (fits && segment->p_vaddr < DATA_SPACE && end > avr->codeend) avr->codeend = end;
    return fits;
  }
  if (segment->p_paddr < EEPROM_SPACE || segment->p_paddr - EEPROM_SPACE >= eeprom_size) return true;
  memset(eeprom, 0xFF, sizeof eeprom);
  if (!copy_segment(elf, segment, eeprom, segment->p_paddr - EEPROM_SPACE, eeprom_size)) return false;
  avr_eeprom_desc_t whole = {.ee = eeprom, .offset = 0, .size = eeprom_size};
  avr_ioctl(avr, AVR_IOCTL_EEPROM_SET, &whole);
  return true;
}

static bool load_segments(struct avr_t *avr, const model *m, const elf_file *elf, const Elf32_Ehdr *header) {
  size_t length = header->e_phnum * sizeof(Elf32_Phdr);
  if (header->e_phentsize != sizeof(Elf32_Phdr) || header->e_phoff > elf->length ||
      length > elf->length - header->e_phoff)
    return false;
  avr->codeend = 0;
  for (size_t i = 0; i < header->e_phnum; i++) {
    Elf32_Phdr segment;
    memcpy(&segment, elf->bytes + header->e_phoff + i * sizeof segment, sizeof segment);
    if (!load_segment(avr, m, elf, &segment)) return false;
  }
  return avr->codeend != 0;
}

int firmware_load(struct avr_t *avr, const model *m, const char *path, char *error, size_t error_size) {
  elf_file elf;
  Elf32_Ehdr header = {0};
  const char *why;
  int result = whole_file_read(&elf, path, &why);
  if (result != 0) {
    snprintf(error, error_size, "%s: %s", path, why);
  } else {
    memcpy(&header, elf.bytes, elf.length < sizeof header ? elf.length : sizeof header);
    result = check_header(&elf, &header, m, path, error, error_size);
  }
  if (result == 0 && !load_segments(avr, m, &elf, &header)) {
    snprintf(error, error_size, "%s is damaged, or holds no program that fits the %s's flash", path, m->chip);
    result = -1;
  }
  whole_file_release(&elf);
  return result;
}

static bool in_boot_section(const struct avr_t *avr, const model *m, const ihex_chunk_t *chunk) {
  uint32_t end = avr->flashend + 1;
  return chunk->baseaddr >= end - m->boot_size && chunk->baseaddr < end && chunk->size <= end - chunk->baseaddr;
}

int firmware_add_boot_loader(struct avr_t *avr, const model *m, const char *path, char *error, size_t error_size) {
  ihex_chunk_p chunks = NULL;
  const char *why;
  FILE *file = open_to_read(path, &why);
  if (!file) {
    snprintf(error, error_size, "%s: %s", path, why);
    return -1;
  }
  fclose(file);  // simavr opens it itself, and would read a folder for ever
  int count = read_ihex_chunks(path, &chunks);
  bool fits = count > 0;
  for (int i = 0; i < count; i++) fits = fits && in_boot_section(avr, m, &chunks[i]);
  for (int i = 0; fits && i < count; i++) {
    memcpy(avr->flash + chunks[i].baseaddr, chunks[i].data, chunks[i].size);
    if (i == 0 || chunks[i].baseaddr < avr->reset_pc) avr->reset_pc = chunks[i].baseaddr;
  }
  if (fits)
    avr->codeend = avr->flashend;
  else
    snprintf(error, error_size,
             "%s holds no boot loader for the %s; expected Intel HEX in the last %u bytes of its"
             " flash",
             path, m->chip, m->boot_size);
  if (chunks) free_ihex_chunks(chunks);
  return fits ? 0 : -1;
}
