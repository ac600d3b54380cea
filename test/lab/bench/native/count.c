// SPDX-License-Identifier: GPL-2.0-or-later
// A plugin of QEMU's: counts the instructions that a program executes, all its threads together. Whoever wants to know
// reads the number, 8 bytes in the machine's own order, from the start of a file at any time.
//
// usage: qemu-arm -plugin libcount.so,to=FILE PROGRAM
//
// The declarations are those of QEMU's include/qemu/qemu-plugin.h, which Debian does not package.
#include <fcntl.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#define EXPORT __attribute__((visibility("default")))

typedef uint64_t plugin_id;
typedef struct block block;
typedef void (*on_translation)(plugin_id id, block *translated);
typedef void (*on_execution)(unsigned cpu, void *data);
enum { NO_REGISTERS };

void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id id, on_translation callback);
void qemu_plugin_register_vcpu_tb_exec_cb(block *translated, on_execution callback, int registers, void *data);
size_t qemu_plugin_tb_n_insns(const block *translated);

// The version of the interface: QEMU 4.2 to 8 take it.
EXPORT int qemu_plugin_version = 1;

static uint64_t *count;

static void executed(unsigned cpu, void *instructions) {
  (void)cpu;
  __atomic_fetch_add(count, (uintptr_t)instructions, __ATOMIC_RELAXED);
}

static void translated(plugin_id id, block *b) {
  (void)id;
  qemu_plugin_register_vcpu_tb_exec_cb(b, executed, NO_REGISTERS, (void *)(uintptr_t)qemu_plugin_tb_n_insns(b));
}

EXPORT int qemu_plugin_install(plugin_id id, const void *host, int arguments, char **argument) {
  (void)host;
  static const char TO[] = "to=";
  if (arguments != 1 || strncmp(argument[0], TO, strlen(TO)) != 0) {
    fprintf(stderr, "count: usage: -plugin libcount.so,to=FILE\n");
    return 1;
  }
  const char *name = argument[0] + strlen(TO);
  int file = open(name, O_RDWR | O_CREAT | O_TRUNC, 0644);
  if (file < 0 || ftruncate(file, sizeof *count) != 0 ||
      (count = mmap(NULL, sizeof *count, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0)) == MAP_FAILED) {
    perror(name);
    return 1;
  }
  close(file);
  qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
  return 0;
}
