// SPDX-License-Identifier: GPL-3.0-or-later
// A Unix domain socket over which others steer the run: JSON lines, each answered by one.
#ifndef JAVINO_CONTROL_H
#define JAVINO_CONTROL_H

#include <poll.h>
#include <stdbool.h>
#include <stddef.h>

#define CONTROL_CLIENTS 16
// The longest line, without its end.
#define CONTROL_MAX_LINE 1024
#define CONTROL_MAX_REPLY 1024
// The most lines of a client that are performed in one exchange.
#define CONTROL_LINES 4

typedef struct {
  void *context;
  // Performs a line. Returns 0, or -1 with one line in `error`.
  int (*perform)(void *context, const char *line, size_t length, char *error, size_t error_size);
} control_listener;

typedef struct {
  int socket;  // -1: none
  char in[CONTROL_MAX_LINE + 1];
  size_t in_length;
  bool skipping;  // the rest of a line that is too long
  char out[CONTROL_MAX_REPLY];
  size_t out_length;  // no line is taken before the client has read the reply to the last one
} control_client;

typedef struct {
  control_listener listener;
  const char *path;  // NULL: there is no socket
  int socket;
  control_client clients[CONTROL_CLIENTS];
} control;

// Makes the socket, for this user only, with its folders, in place of one that nobody serves any more; without a path
// does nothing. Returns 0, or -1 with one line in `error`; anything else at `path` is left alone.
int control_open(control *c, const char *path, control_listener listener, char *error, size_t error_size);

// Writes the reply to a command as one line: to one that was performed where `error` is NULL. Returns its length.
size_t control_reply(char reply[CONTROL_MAX_REPLY], const char *error);

// Takes the socket away.
void control_close(control *c);

// Performs what the clients have sent, without waiting.
void control_exchange(control *c);

// Fills in what to wait on; `descriptors` has room for CONTROL_CLIENTS + 1. Returns how many there are.
size_t control_descriptors(const control *c, struct pollfd *descriptors);

#endif
