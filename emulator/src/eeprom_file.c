// SPDX-License-Identifier: GPL-3.0-or-later
#include "eeprom_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <simavr/avr_eeprom.h>
#include <simavr/sim_avr.h>

#include "paths.h"

// How often the file may be replaced, or appear, while it is opened: a symlink that leads nowhere does so for ever.
#define MOST_TRIES 100

static int fail(char *error, size_t error_size, const char *path) {
  snprintf(error, error_size, "EEPROM file %s: %s", path, private_problem());
  return -1;
}

// Reads the file that is open, which has keys. Returns 0, or -1 with one line in `error`.
static int read_file(eeprom_file *file, char *error, size_t error_size) {
  struct stat status;
  if (keep_private(file->lock) != 0 || fstat(file->lock, &status) != 0) return fail(error, error_size, file->path);
  if (status.st_size == file->size && pread(file->lock, file->saved, (size_t)file->size, 0) == file->size) return 0;
  snprintf(error, error_size, "EEPROM file %s: expected exactly %d bytes; remove it to start anew", file->path,
           file->size);
  return -1;
}

// Takes the lock of the file that is open. Returns 1, 0 where the file was replaced meanwhile, or -1 with one line in
// `error`.
static int take_lock(const eeprom_file *file, char *error, size_t error_size) {
  struct stat ours, present;
  if (flock(file->lock, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) return fail(error, error_size, file->path);
    snprintf(error, error_size,
             "EEPROM file %s: another emulator or board uses it; end that one or choose another file", file->path);
    return -1;
  }
  return fstat(file->lock, &ours) == 0 && stat(file->path, &present) == 0 && ours.st_ino == present.st_ino &&
         ours.st_dev == present.st_dev;
}

// Writes the chip's bytes to a file beside the one that is kept, and locks it. Returns its descriptor or -1.
static int write_beside(const eeprom_file *file, const char *path) {
  unlink(path);  // whatever lies there under a name of ours
  int descriptor = open_private(path, false);
  if (descriptor < 0) return -1;
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 && write(descriptor, file->live, (size_t)file->size) == file->size)
    return descriptor;
  close(descriptor);
  return -1;
}

static void keep(eeprom_file *file, int descriptor) {
  if (file->lock >= 0) close(file->lock);
  file->lock = descriptor;
  memcpy(file->saved, file->live, (size_t)file->size);
}

// Puts the chip's bytes in the file's place, in one piece and locked all the time.
// Returns 0, or -1 with errno set; EEXIST where the file is to be new and there is one.
static int put_in_place(eeprom_file *file, bool fresh) {
  char beside[4096];
  snprintf(beside, sizeof beside, "%s.%ld.new", file->path, (long)getpid());
  int descriptor = make_folders_for(file->path) == 0 ? write_beside(file, beside) : -1;
  int placed = descriptor < 0 ? -1 : fresh ? link(beside, file->path) : rename(beside, file->path);
  if (placed != 0 && descriptor >= 0 && fresh && errno != EEXIST)  // a file system without hard links
    placed = rename(beside, file->path);
  int problem = errno;
  unlink(beside);  // nothing, where it was renamed
  if (placed == 0)
    keep(file, descriptor);
  else if (descriptor >= 0)
    close(descriptor);
  errno = problem;
  return placed;
}

// Opens and locks the file, or makes it of what the chip holds. Returns 1 when it was there, 0 when made, -1 on failure.
static int open_locked(eeprom_file *file, char *error, size_t error_size) {
  for (int tries = 0; tries < MOST_TRIES; tries++) {
    file->lock = open(file->path, O_RDONLY | O_CLOEXEC);
    if (file->lock < 0 && errno == ENOENT && put_in_place(file, true) == 0) return 0;
    if (file->lock < 0 && errno != EEXIST) return fail(error, error_size, file->path);
    int locked = file->lock < 0 ? 0 : take_lock(file, error, error_size);
    if (locked != 0) return locked;
    if (file->lock >= 0) close(file->lock);
    file->lock = -1;
  }
  return fail(error, error_size, file->path);
}

int eeprom_file_open(eeprom_file *file, struct avr_t *avr, int size, const char *path, char *error, size_t error_size) {
  avr_eeprom_desc_t whole = {.ee = NULL, .offset = 0, .size = (uint32_t)size};
  avr_ioctl(avr, AVR_IOCTL_EEPROM_GET, &whole);
  *file = (eeprom_file){.path = path, .size = size, .live = whole.ee, .lock = -1};
  int found = open_locked(file, error, error_size);
  if (found < 0 || (found && read_file(file, error, error_size) != 0)) {
    eeprom_file_close(file);
    return -1;
  }
  if (found) {
    whole.ee = file->saved;
    avr_ioctl(avr, AVR_IOCTL_EEPROM_SET, &whole);
  }
  return 0;
}

int eeprom_file_save(eeprom_file *file, char *error, size_t error_size) {
  if (memcmp(file->live, file->saved, (size_t)file->size) == 0 || put_in_place(file, false) == 0) return 0;
  return fail(error, error_size, file->path);
}

void eeprom_file_close(eeprom_file *file) {
  if (file->live && file->lock >= 0) close(file->lock);
  file->live = NULL;
}
