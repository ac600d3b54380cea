// SPDX-License-Identifier: GPL-3.0-or-later
#include "pty.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include "paths.h"

// Stands for the master of a played port.
#define PLAYED 0

static int fail(char *error, size_t error_size, const char *what, const char *path) {
  snprintf(error, error_size, "port %s: %s: %s", path, what, strerror(errno));
  return -1;
}

static int open_master(pty *p) {
  p->master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (p->master < 0) return -1;
  struct termios settings;
  if (grantpt(p->master) != 0 || unlockpt(p->master) != 0 || ptsname_r(p->master, p->slave, sizeof p->slave) != 0 ||
      tcgetattr(p->master, &settings) != 0)
    return -1;
  cfmakeraw(&settings);
  return tcsetattr(p->master, TCSANOW, &settings);
}

// Opening the slave once makes the kernel report from now on when no host has it open; what a
// host has left unread goes, as it does in a real serial driver.
static void flush_slave(const pty *p) {
  int slave = open(p->slave, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (slave < 0) return;  // then there is nothing to flush either
  tcflush(slave, TCIOFLUSH);
  close(slave);
}

static int make_link(const pty *p, char *error, size_t error_size) {
  struct stat status;
  char temporary[4096];
  if (lstat(p->link, &status) == 0 && !S_ISLNK(status.st_mode)) {
    snprintf(error, error_size,
             "port %s: there is something that is no symlink; "
             "remove it or choose another path",
             p->link);
    return -1;
  }
  if (make_folders_for(p->link) != 0) return fail(error, error_size, "cannot make its folder", p->link);
  snprintf(temporary, sizeof temporary, "%s.%ld.new", p->link, (long)getpid());
  if (symlink(p->slave, temporary) != 0) return fail(error, error_size, "cannot make the symlink", p->link);
  if (rename(temporary, p->link) != 0) {
    fail(error, error_size, "cannot put the symlink in place", p->link);
    unlink(temporary);
    return -1;
  }
  return 0;
}

int pty_plug(pty *p, const char *link, char *error, size_t error_size) {
  p->link = link;
  p->open = false;
  p->in_start = p->in_end = p->out_length = 0;
  if (p->played) {
    p->master = PLAYED;
    return 0;
  }
  int result = open_master(p);
  if (result != 0) fail(error, error_size, "cannot make a pseudo-terminal", link);
  if (result == 0) {
    flush_slave(p);
    result = make_link(p, error, error_size);
  }
  if (result != 0 && p->master >= 0) {
    close(p->master);
    p->master = -1;
  }
  return result;
}

static void remove_link_and_master(const pty *p) {
  char target[sizeof p->slave];
  // The path may by now be another process's.
  ssize_t length = readlink(p->link, target, sizeof target);
  if (length == (ssize_t)strlen(p->slave) && memcmp(target, p->slave, (size_t)length) == 0) unlink(p->link);
  close(p->master);
}

// The kernel takes the STOP out of what the host reads, and forgets it when IXON ends.
static void control_flow(const pty *p) {
  static const char STOP = 0x13;
  struct termios settings;
  if (tcgetattr(p->master, &settings) != 0) return;  // unplugged
  settings.c_iflag = p->held ? settings.c_iflag | IXON : settings.c_iflag & ~(tcflag_t)IXON;
  settings.c_cc[VSTOP] = STOP;
  if (tcsetattr(p->master, TCSANOW, &settings) != 0 || !p->held) return;
  if (write(p->master, &STOP, 1) != 1) return;  // a host that reads nothing waits for nothing
}

void pty_hold(pty *p, bool held) {
  if (p->held == held) return;
  p->held = held;
  if (!p->played && (p->open || !held)) control_flow(p);
}

static void forget_host(pty *p) {
  p->open = false;
  p->dropped += p->out_length;
  p->in_start = p->in_end = p->out_length = 0;
}

void pty_unplug(pty *p) {
  if (p->master < 0) return;
  if (!p->played) remove_link_and_master(p);
  p->master = -1;
  forget_host(p);
}

static void given(pty *p, size_t count) {
  p->gave = count;
  p->sent += count;
  p->out_length -= count;
  memmove(p->out, p->out + count, p->out_length);
}

static void write_out(pty *p, cycles_t now) {
  size_t ready = p->out_length - bridge_held(&p->usb, now);
  if (ready == 0 || p->held) return;
  ssize_t written = write(p->master, p->out, ready);
  if (written <= 0) return;  // the host does not read now; what does not fit the buffer is counted by pty_put
  given(p, (size_t)written);
}

static void taken(pty *p, size_t count) {
  p->got = count;
  p->received += count;
  p->in_end += count;
}

size_t pty_room(pty *p) {
  if (p->in_start == p->in_end) p->in_start = p->in_end = 0;
  return PTY_BUFFER - p->in_end;
}

static void read_in(pty *p) {
  if (pty_room(p) == 0) return;  // the rest waits in the kernel
  ssize_t length = read(p->master, p->in + p->in_end, PTY_BUFFER - p->in_end);
  if (length <= 0) return;  // nothing there, or no host, which pty_exchange sees by itself
  taken(p, (size_t)length);
}

static void host_gone(pty *p) {
  forget_host(p);
  flush_slave(p);
}

int pty_play(pty *p, pty_change change, const uint8_t *bytes, size_t length, size_t gave) {
  bool open = change == PTY_SAME ? p->open : change == PTY_OPENED;
  if (p->master < 0 || (!open && length + gave > 0) || length > pty_room(p) || gave > p->out_length) return -1;
  p->coming = change;
  memcpy(p->in + p->in_end, bytes, length);
  taken(p, length);
  p->gave = gave;
  return 0;
}

static pty_change play(pty *p, cycles_t now) {
  pty_change change = p->coming;
  p->coming = PTY_SAME;
  if (change == PTY_CLOSED)
    forget_host(p);
  else
    given(p, p->gave);
  p->gave = 0;
  if (change == PTY_OPENED) {
    p->open = true;
    bridge_start(&p->usb, now);
  }
  return change;
}

pty_change pty_exchange(pty *p, cycles_t now) {
  if (p->master >= 0 && p->played) return play(p, now);
  p->got = p->gave = 0;
  if (p->master < 0) return PTY_SAME;
  struct pollfd state = {p->master, POLLIN, 0};
  poll(&state, 1, 0);
  bool open = !(state.revents & POLLHUP);
  bool was_open = p->open;
  if (was_open && !open) {
    host_gone(p);
    return PTY_CLOSED;
  }
  p->open = open;
  if (open && !was_open) bridge_start(&p->usb, now);
  if (open && !was_open && p->held) control_flow(p);
  if (open && (state.revents & POLLIN)) read_in(p);
  if (open) write_out(p, now);
  return open && !was_open ? PTY_OPENED : PTY_SAME;
}

bool pty_take(pty *p, uint8_t *byte) {
  if (p->in_start == p->in_end) return false;
  *byte = p->in[p->in_start++];
  return true;
}

void pty_put(pty *p, uint8_t byte, cycles_t now) {
  if (!p->open || p->out_length == PTY_BUFFER) {
    p->dropped++;
    return;
  }
  p->out[p->out_length++] = byte;
  p->put_at = now;
  bridge_put(&p->usb, now);
}

int pty_poll_descriptor(const pty *p) { return p->open && p->in_end < PTY_BUFFER ? p->master : -1; }
