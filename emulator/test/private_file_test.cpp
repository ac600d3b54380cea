// SPDX-License-Identifier: GPL-3.0-or-later
// Files that hold keys: EEPROMs, records, and those of --keys.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "support.h"

extern "C" {
#include "paths.h"
}

static bool forgets_permissions;

// The fstat of all tests; with `forgets_permissions` as on a stick, where all may read everything, whatever chmod says.
extern "C" int fstat(int descriptor, struct stat *status) noexcept {
  static const auto real = reinterpret_cast<int (*)(int, struct stat *)>(dlsym(RTLD_NEXT, "fstat"));
  const int result = real(descriptor, status);
  if (forgets_permissions) status->st_mode |= 0066;
  return result;
}

static unsigned mode(const std::string &path) {
  struct stat status = {};
  return lstat(path.c_str(), &status) == 0 ? status.st_mode & 0777u : 0;
}

static const char BOOT[] = R"({"boards":[{"name":"a","firmware":"@boot_count","eeprom":"a.bin"}]})";

static std::string refusal(Scratch &scratch) {
  try {
    Emulation run(scratch, BOOT);
    return "none";
  } catch (const std::runtime_error &e) {
    return e.what();
  }
}

TEST(PrivateFile, of_an_eeprom_is_for_its_user_only) {
  Scratch scratch;
  umask(022);
  Emulation run(scratch, BOOT);
  EXPECT_EQ(mode(scratch.path("a.bin")), 0600u);
  run.run_until(0.2);
  EXPECT_EQ(read_text(scratch.path("a.bin"))[0], '\0');
  EXPECT_EQ(mode(scratch.path("a.bin")), 0600u);
}

TEST(PrivateFile, of_an_eeprom_that_others_could_read_is_closed_to_them) {
  Scratch scratch;
  scratch.write("a.bin", std::string(4096, '\xFF'));
  chmod(scratch.path("a.bin").c_str(), 0644);
  Emulation run(scratch, BOOT);
  EXPECT_EQ(mode(scratch.path("a.bin")), 0600u);
}

TEST(PrivateFile, of_an_eeprom_is_written_to_no_link) {
  Scratch scratch;
  scratch.write("target", "mine");
  const std::string planted = scratch.path("a.bin." + std::to_string(getpid()) + ".new");
  ASSERT_EQ(symlink(scratch.path("target").c_str(), planted.c_str()), 0);
  Emulation run(scratch, BOOT);
  EXPECT_EQ(read_text(scratch.path("target")), "mine");
  EXPECT_FALSE(std::filesystem::is_symlink(scratch.path("a.bin")));
  EXPECT_EQ(read_text(scratch.path("a.bin")).size(), 4096u);
}

TEST(PrivateFile, where_permissions_cannot_be_kept_is_refused_and_not_left) {
  if (sizeof(void *) < 8) GTEST_SKIP() << "there fstat has another name";
  for (bool found : {false, true}) {
    Scratch scratch;
    if (found) scratch.write("a.bin", std::string(4096, '\xFF'));
    forgets_permissions = true;
    const std::string said = refusal(scratch);
    const int made = open_private(scratch.path("keys").c_str(), true);
    forgets_permissions = false;
    EXPECT_EQ(said, "EEPROM file " + scratch.path("a.bin") +
                        ": others could read the keys in it, as its permissions cannot be kept; "
                        "choose a folder in your home");
    EXPECT_LT(made, 0);
    for (const auto &left : std::filesystem::directory_iterator(scratch.folder)) {
      const std::string name = left.path().filename();
      EXPECT_TRUE((name.find("a.bin") != 0 || (found && name == "a.bin")) && name != "keys") << name;
    }
  }
}

TEST(PrivateFile, follows_no_link_and_writes_to_no_device) {
  Scratch scratch;
  scratch.write("target", "mine");
  ASSERT_EQ(symlink(scratch.path("target").c_str(), scratch.path("link").c_str()), 0);
  ASSERT_EQ(mkfifo(scratch.path("fifo").c_str(), 0600), 0);
  for (bool add : {false, true}) {
    for (const char *name : {"link", "fifo"}) {
      EXPECT_LT(open_private(scratch.path(name).c_str(), add), 0) << name;
      EXPECT_TRUE(errno == ENXIO || strstr(private_problem(), "it is a link or no file")) << name << strerror(errno);
    }
  }
  EXPECT_EQ(read_text(scratch.path("target")), "mine");
}

TEST(PrivateFile, that_was_open_elsewhere_is_made_anew_and_one_to_add_to_is_closed_to_others) {
  Scratch scratch;
  scratch.write("old", "old");
  chmod(scratch.path("old").c_str(), 0644);
  const int elsewhere = open(scratch.path("old").c_str(), O_RDONLY);
  for (bool add : {true, false}) {
    const int descriptor = open_private(scratch.path("old").c_str(), add);
    ASSERT_EQ(write(descriptor, "key", 3), 3);
    close(descriptor);
    EXPECT_EQ(read_text(scratch.path("old")), add ? "oldkey" : "key");
    EXPECT_EQ(mode(scratch.path("old")), 0600u);
  }
  char seen[16];
  EXPECT_EQ(read(elsewhere, seen, sizeof seen), 6) << "what it was";
  close(elsewhere);
}
