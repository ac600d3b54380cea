// SPDX-License-Identifier: GPL-3.0-or-later
#include "control.h"

#include <errno.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "paths.h"

static int fail(char *error, size_t error_size, const char *path, const char *what) {
  snprintf(error, error_size, "--control %s: %s", path, what);
  return -1;
}

// Whether another process serves the socket.
static bool served(const struct sockaddr_un *address) {
  int probe = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  bool answered = connect(probe, (const struct sockaddr *)address, sizeof *address) == 0 || errno == EAGAIN;
  close(probe);
  return answered;
}

// Makes room for the socket. Returns 0, or -1 with one line in `error`.
static int make_room(const struct sockaddr_un *address, char *error, size_t error_size) {
  const char *path = address->sun_path;
  struct stat status;
  if (make_folders_for(path) != 0) return fail(error, error_size, path, strerror(errno));
  if (lstat(path, &status) != 0) return 0;
  if (!S_ISSOCK(status.st_mode))
    return fail(error, error_size, path, "there is something that is no socket; remove it or choose another path");
  if (served(address))
    return fail(error, error_size, path, "another emulator uses it; end that one or choose another path");
  return unlink(path) == 0 ? 0 : fail(error, error_size, path, strerror(errno));
}

int control_open(control *c, const char *path, control_listener listener, char *error, size_t error_size) {
  struct sockaddr_un address = {.sun_family = AF_UNIX};
  memset(c, 0, sizeof *c);
  c->listener = listener;
  c->socket = -1;
  for (int i = 0; i < CONTROL_CLIENTS; i++) c->clients[i].socket = -1;
  if (!path) return 0;
  if (strlen(path) >= sizeof address.sun_path)
    return fail(error, error_size, path, "the path is too long; expected at most 107 bytes");
  strcpy(address.sun_path, path);
  if (make_room(&address, error, error_size) != 0) return -1;
  c->socket = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  mode_t before = umask(S_IRWXG | S_IRWXO);
  int bound = c->socket < 0 ? -1 : bind(c->socket, (const struct sockaddr *)&address, sizeof address);
  umask(before);
  if (bound == 0) c->path = path;
  if (bound == 0 && listen(c->socket, CONTROL_CLIENTS) == 0) return 0;
  fail(error, error_size, path, strerror(errno));
  control_close(c);
  return -1;
}

static void hang_up(control_client *client) {
  if (client->socket >= 0) close(client->socket);
  client->socket = -1;
}

void control_close(control *c) {
  for (int i = 0; i < CONTROL_CLIENTS; i++) hang_up(&c->clients[i]);
  if (c->path) unlink(c->path);
  if (c->socket >= 0) close(c->socket);
  c->path = NULL;
  c->socket = -1;
}

static void accept_clients(control *c) {
  for (int i = 0; i < CONTROL_CLIENTS; i++) {
    control_client *client = &c->clients[i];
    if (client->socket >= 0) continue;
    *client = (control_client){.socket = accept4(c->socket, NULL, NULL, SOCK_NONBLOCK | SOCK_CLOEXEC)};
    if (client->socket < 0) return;  // nobody is there; more than CONTROL_CLIENTS wait
  }
}

size_t control_reply(char reply[CONTROL_MAX_REPLY], const char *error) {
  json_t *object = error ? json_pack("{ss}", "error", error) : json_pack("{sb}", "ok", 1);
  size_t length = object ? json_dumpb(object, reply, CONTROL_MAX_REPLY - 1, JSON_COMPACT) : 0;
  json_decref(object);
  if (length == 0 || length >= CONTROL_MAX_REPLY)
    length = (size_t)snprintf(reply, CONTROL_MAX_REPLY - 1, "{\"error\":\"the command is wrong, and is no UTF-8\"}");
  reply[length] = '\n';
  return length + 1;
}

static void reply(control_client *client, const char *error) { client->out_length = control_reply(client->out, error); }

static void write_out(control_client *client) {
  ssize_t written = send(client->socket, client->out, client->out_length, MSG_NOSIGNAL);
  if (written < 0 && errno != EAGAIN && errno != EINTR) {
    hang_up(client);
    return;
  }
  if (written <= 0) return;
  client->out_length -= (size_t)written;
  memmove(client->out, client->out + written, client->out_length);
}

static void perform(control *c, control_client *client, size_t length) {
  char error[512];
  bool ok = c->listener.perform(c->listener.context, client->in, length, error, sizeof error) == 0;
  reply(client, ok ? NULL : error);
}

// Performs the first line that is there. Returns whether there was one.
static bool take_line(control *c, control_client *client) {
  char *end = memchr(client->in, '\n', client->in_length);
  if (!end && client->in_length < sizeof client->in) return false;
  size_t length = end ? (size_t)(end - client->in) : client->in_length;
  bool skipped = client->skipping;
  client->skipping = !end;
  if (end && !skipped)
    perform(c, client, length);
  else if (!end && !skipped)
    reply(client, "the line is longer than 1024 bytes; expected one command a line");
  size_t used = end ? length + 1 : length;
  client->in_length -= used;
  memmove(client->in, client->in + used, client->in_length);
  return true;
}

// Answers lines that are there, as long as the client reads; only so many, as one that floods shall not stop the run.
static void answer(control *c, control_client *client) {
  for (int lines = 0; lines <= CONTROL_LINES; lines++) {
    if (client->out_length > 0) write_out(client);
    if (client->socket < 0 || client->out_length > 0 || lines == CONTROL_LINES || !take_line(c, client)) return;
  }
}

// The client will say no more: its last line may lack its end, and some may wait.
static void finish(control_client *client) {
  if (client->in_length == 0)
    hang_up(client);
  else if (client->in[client->in_length - 1] != '\n')
    client->in[client->in_length++] = '\n';
}

static void exchange(control *c, control_client *client) {
  size_t room = sizeof client->in - client->in_length;
  if (room > 0 && client->out_length == 0) {
    ssize_t length = recv(client->socket, client->in + client->in_length, room, 0);
    if (length > 0) client->in_length += (size_t)length;
    if (length == 0) finish(client);
    if (length < 0 && errno != EAGAIN && errno != EINTR) hang_up(client);
  }
  if (client->socket >= 0) answer(c, client);
}

void control_exchange(control *c) {
  if (c->socket < 0) return;
  accept_clients(c);
  for (int i = 0; i < CONTROL_CLIENTS; i++)
    if (c->clients[i].socket >= 0) exchange(c, &c->clients[i]);
}

size_t control_descriptors(const control *c, struct pollfd *descriptors) {
  size_t count = 0;
  bool full = true;
  for (int i = 0; i < CONTROL_CLIENTS; i++) {
    const control_client *client = &c->clients[i];
    full &= client->socket >= 0;
    if (client->socket >= 0)
      descriptors[count++] = (struct pollfd){client->socket, (short)(client->out_length > 0 ? POLLOUT : POLLIN), 0};
  }
  if (c->socket >= 0 && !full) descriptors[count++] = (struct pollfd){c->socket, POLLIN, 0};
  return count;
}
