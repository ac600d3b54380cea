// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

int make_folders_for(const char *path) {
  char *copy = strdup(path);
  int result = copy ? 0 : -1;
  for (char *slash = copy ? strchr(copy + 1, '/') : NULL; slash && result == 0; slash = strchr(slash + 1, '/')) {
    *slash = '\0';
    if (mkdir(copy, 0777) != 0 && errno != EEXIST) result = -1;
    *slash = '/';
  }
  free(copy);
  return result;
}

int keep_private(int descriptor) {
  struct stat status;
  if (fstat(descriptor, &status) != 0) return -1;
  if (!S_ISREG(status.st_mode)) {
    errno = EEXIST;
    return -1;
  }
  bool shared = status.st_mode & (S_IRWXG | S_IRWXO);
  if (shared && (fchmod(descriptor, S_IRUSR | S_IWUSR) != 0 || fstat(descriptor, &status) != 0)) return -1;
  if (!(status.st_mode & (S_IRWXG | S_IRWXO))) return 0;
  errno = EPERM;
  return -1;
}

int open_private(const char *path, bool add) {
  int flags = (add ? O_WRONLY | O_APPEND : O_RDWR) | O_NOFOLLOW | O_CLOEXEC;
  struct stat status;
  // A file that was there may be open elsewhere.
  if (!add && lstat(path, &status) == 0 && S_ISREG(status.st_mode)) unlink(path);
  int descriptor = open(path, flags | O_CREAT | O_EXCL, S_IRUSR | S_IWUSR);
  bool made = descriptor >= 0;
  if (!made && errno == EEXIST && add) descriptor = open(path, flags | O_NONBLOCK);
  if (descriptor < 0 || keep_private(descriptor) == 0) return descriptor;
  int problem = errno;
  if (made) unlink(path);
  close(descriptor);
  errno = problem;
  return -1;
}

const char *private_problem(void) {
  switch (errno) {
    case EPERM:
      return "others could read the keys in it, as its permissions cannot be kept; choose a folder in your home";
    case EEXIST:
    case ELOOP: return "it is a link or no file; choose another path";
    default: return strerror(errno);
  }
}
