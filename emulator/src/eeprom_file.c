// SPDX-License-Identifier: GPL-3.0-or-later
#include "eeprom_file.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <simavr/avr_eeprom.h>
#include <simavr/sim_avr.h>

#include "paths.h"

static int fail(char *error, size_t error_size, const char *path)
{
    snprintf(error, error_size, "EEPROM file %s: %s", path, strerror(errno));
    return -1;
}

// Returns 1 when read, 0 when there is no file, -1 on failure.
static int read_file(uint8_t *bytes, int size, const char *path, char *error, size_t error_size)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return errno == ENOENT ? 0 : fail(error, error_size, path);
    size_t length = fread(bytes, 1, (size_t)size, file);
    bool more = fgetc(file) != EOF;
    fclose(file);
    if (length == (size_t)size && !more)
        return 1;
    snprintf(error, error_size, "EEPROM file %s: expected exactly %d bytes; remove it to start anew",
             path, size);
    return -1;
}

static int write_file(const uint8_t *bytes, int size, const char *path)
{
    FILE *file = fopen(path, "wb");
    if (!file)
        return -1;
    size_t length = fwrite(bytes, 1, (size_t)size, file);
    int closed = fclose(file);
    return length == (size_t)size && closed == 0 ? 0 : -1;
}

int eeprom_file_open(eeprom_file *file, struct avr_t *avr, int size, const char *path, char *error,
                     size_t error_size)
{
    avr_eeprom_desc_t whole = {.ee = NULL, .offset = 0, .size = (uint32_t)size};
    file->size = size;
    file->path = path;
    avr_ioctl(avr, AVR_IOCTL_EEPROM_GET, &whole);
    file->live = whole.ee;
    int found = read_file(file->saved, size, path, error, error_size);
    if (found < 0)
        return -1;
    if (found) {
        whole.ee = file->saved;
        avr_ioctl(avr, AVR_IOCTL_EEPROM_SET, &whole);
        return 0;
    }
    // Differs in each byte from what the chip holds, so that the file is written.
    for (int i = 0; i < size; i++)
        file->saved[i] = (uint8_t)~file->live[i];
    return eeprom_file_save(file, error, error_size);
}

int eeprom_file_save(eeprom_file *file, char *error, size_t error_size)
{
    char temporary[4096];
    if (memcmp(file->live, file->saved, (size_t)file->size) == 0)
        return 0;
    snprintf(temporary, sizeof temporary, "%s.%ld.new", file->path, (long)getpid());
    if (make_folders_for(file->path) != 0 || write_file(file->live, file->size, temporary) != 0 ||
        rename(temporary, file->path) != 0) {
        fail(error, error_size, file->path);
        unlink(temporary);
        return -1;
    }
    memcpy(file->saved, file->live, (size_t)file->size);
    return 0;
}
