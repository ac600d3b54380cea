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

#include "eeprom_file.h"
#include "intel_hex.h"
#include "whole_file.h"

// The bits of an AVR ELF's flags that name the family (binutils, include/elf/avr.h).
#define AVR_FAMILY_MASK 0x7F

// The addresses from which the AVR linker puts all that is not in flash: data space, and in it the EEPROM.
#define DATA_SPACE 0x800000
#define EEPROM_SPACE 0x810000

// Nothing in a file is trusted: one that is cut off or damaged is refused.

// Checks that the header is that of an ELF file for the model's chip.
static int check_header(const whole_file *elf, const Elf32_Ehdr *header, const model *m, const char *path, char *error,
                        size_t error_size) {
  if (elf->length < sizeof *header || memcmp(header->e_ident, ELFMAG, SELFMAG) != 0)
    snprintf(error, error_size, "%s is neither ELF nor Intel HEX; expected the .elf or .hex of a build for an AVR",
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
static bool copy_segment(const whole_file *elf, const Elf32_Phdr *segment, uint8_t *base, uint32_t at, uint32_t size) {
  bool in_file = segment->p_offset <= elf->length && segment->p_filesz <= elf->length - segment->p_offset;
  if (!in_file || at > size || segment->p_filesz > size - at) return false;
  memcpy(base + at, elf->bytes + segment->p_offset, segment->p_filesz);
  return true;
}

// Loads what is for the flash, with the initial values of data behind the code, or for the EEPROM. All else (fuses, what
// simavr itself would take from a program, such as orders to write traces to files) is left out.
static bool load_segment(struct avr_t *avr, const model *m, const whole_file *elf, const Elf32_Phdr *segment) {
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

static bool load_segments(struct avr_t *avr, const model *m, const whole_file *elf, const Elf32_Ehdr *header) {
  size_t length = header->e_phnum * sizeof(Elf32_Phdr);
  if (header->e_phentsize != sizeof(Elf32_Phdr) || header->e_phoff > elf->length ||
      length > elf->length - header->e_phoff)
    return false;
  for (size_t i = 0; i < header->e_phnum; i++) {
    Elf32_Phdr segment;
    memcpy(&segment, elf->bytes + header->e_phoff + i * sizeof segment, sizeof segment);
    if (!load_segment(avr, m, elf, &segment)) return false;
  }
  return avr->codeend != 0;
}

// Copies an Intel HEX file, which does not tell for which chip it is, to the part of the flash that begins at `first`.
static bool load_hex(struct avr_t *avr, const whole_file *file, uint32_t first, hex_target *target) {
  *target = (hex_target){.memory = avr->flash, .first = first, .limit = avr->flashend + 1};
  return intel_hex_copy(file->bytes, file->length, target);
}

int firmware_load(struct avr_t *avr, const model *m, const char *path, char *error, size_t error_size) {
  whole_file file;
  Elf32_Ehdr header = {0};
  hex_target target;
  const char *why;
  bool loaded = false;
  int result = whole_file_read(&file, path, &why);
  if (result != 0) {
    snprintf(error, error_size, "%s: %s", path, why);
    return result;
  }
  avr->codeend = 0;
  if (intel_hex_begins(file.bytes, file.length)) {
    loaded = load_hex(avr, &file, 0, &target) && target.lowest == 0;
    avr->codeend = target.end;
  } else {
    memcpy(&header, file.bytes, file.length < sizeof header ? file.length : sizeof header);
    result = check_header(&file, &header, m, path, error, error_size);
    loaded = result == 0 && load_segments(avr, m, &file, &header);
  }
  if (result == 0 && !loaded) {
    snprintf(error, error_size, "%s is damaged, or holds no program that fits the %s's flash", path, m->chip);
    result = -1;
  }
  whole_file_release(&file);
  return result;
}

int firmware_add_boot_loader(struct avr_t *avr, const model *m, const char *path, char *error, size_t error_size) {
  whole_file file;
  hex_target target;
  const char *why;
  if (whole_file_read(&file, path, &why) != 0) {
    snprintf(error, error_size, "%s: %s", path, why);
    return -1;
  }
  bool loaded = load_hex(avr, &file, avr->flashend + 1 - m->boot_size, &target);
  whole_file_release(&file);
  if (!loaded) {
    snprintf(error, error_size,
             "%s holds no boot loader for the %s; expected Intel HEX in the last %u bytes of its"
             " flash",
             path, m->chip, m->boot_size);
    return -1;
  }
  avr->reset_pc = target.lowest;
  avr->codeend = avr->flashend;
  return 0;
}
