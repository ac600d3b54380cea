// SPDX-License-Identifier: GPL-3.0-or-later
// The program in lock-step: its input, its end, its files.
#include "support.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace {

const char ECHO_ALONE[] = R"({"boards":[{"name":"a","firmware":"@uart_echo","port":"a"}]})";

struct Outcome {
  int status;
  std::string out, errors;
};

Outcome emulate(const Scratch &scratch, const std::string &json, const std::string &input,
                const std::string &options = "") {
  std::string scenario = scratch.write("s.json", with_programs(json));
  std::string in = scratch.write("in", input), out = scratch.path("out"), errors = scratch.path("errors");
  std::string line = EMULATOR " '" + scenario + "' --lockstep --directory '" + scratch.folder + "' " + options + " <'" +
                     in + "' >'" + out + "' 2>'" + errors + "'";
  int result = std::system(line.c_str());
  return {WIFEXITED(result) ? WEXITSTATUS(result) : -1, read_text(out), read_text(errors)};
}

}  // namespace

namespace {

// The program while it waits for lines.
struct Program {
  Program(const Scratch &scratch, const std::string &json) : control(scratch.path("control")) {
    const std::string scenario = scratch.write("s.json", with_programs(json));
    int in[2], out[2];
    EXPECT_EQ(pipe2(in, O_CLOEXEC) + pipe2(out, O_CLOEXEC), 0);
    child = fork();
    if (child == 0) {
      dup2(in[0], STDIN_FILENO);
      dup2(out[1], STDOUT_FILENO);
      execl(EMULATOR, EMULATOR, scenario.c_str(), "--lockstep", "--directory", scratch.folder.c_str(), "--control",
            control.c_str(), nullptr);
      _exit(127);
    }
    close(in[0]);
    close(out[1]);
    to = in[1];
    from = fdopen(out[0], "r");
  }
  ~Program() {
    if (child > 0) finish();
    fclose(from);
  }

  std::string say(const std::string &line) { return dprintf(to, "%s\n", line.c_str()) > 0 ? answer(from) : ""; }
  // As a client of the control socket.
  std::string command(const std::string &line) {
    const int fd = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    snprintf(address.sun_path, sizeof address.sun_path, "%s", control.c_str());
    EXPECT_EQ(connect(fd, reinterpret_cast<sockaddr *>(&address), sizeof address), 0);
    dprintf(fd, "%s\n", line.c_str());
    FILE *replies = fdopen(fd, "r");
    const std::string reply = answer(replies);
    fclose(replies);
    return reply;
  }
  // Ends its input, and returns its exit status.
  int finish() {
    if (to >= 0) close(to);
    to = -1;
    int status = -1;
    waitpid(child, &status, 0);
    child = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  static std::string answer(FILE *file) {
    char text[1024];
    return fgets(text, sizeof text, file) ? text : "";
  }

  std::string control;
  pid_t child;
  int to;
  FILE *from;
};

}  // namespace

TEST(LockstepProgram, serves_the_control_socket_while_it_waits) {
  Scratch scratch;
  Program program(scratch, ECHO_ALONE);
  EXPECT_EQ(program.say("run 1"), "1600\n");
  EXPECT_EQ(program.command(R"({"do":"unplug","board":"a"})"), "{\"ok\":true}\n");
  EXPECT_EQ(program.command(R"({"do":"speed","value":1})"),
            "{\"error\":\"command: there is no speed in lock-step; leave it out\"}\n");
  EXPECT_EQ(program.say("run 16000"), "1600 0 unplugged\n");
  EXPECT_EQ(program.finish(), 0);
}

TEST(LockstepProgram, ends_at_a_signal_and_writes_eeprom_files) {
  Scratch scratch;
  Program program(scratch, R"({"boards":[{"name":"a","firmware":"@boot_count","eeprom":"a.bin"}]})");
  EXPECT_EQ(program.say("run 160000"), "160000\n");
  kill(program.child, SIGTERM);
  EXPECT_EQ(Program::answer(program.from), "");
  EXPECT_EQ(program.finish(), 0);
  EXPECT_EQ(read_text(scratch.path("a.bin"))[0], '\0');
}

TEST(LockstepProgram, ends_with_its_input_and_writes_eeprom_files) {
  Scratch scratch;
  const char JSON[] = R"({"boards":[{"name":"a","firmware":"@boot_count","eeprom":"a.bin","port":"a"}]})";
  for (char count : {0, 1}) {
    Outcome o = emulate(scratch, JSON, "run 160000\n", "--trace '" + scratch.path("t") + "'");
    EXPECT_EQ(o.status, 0);
    EXPECT_EQ(o.out, "160000\n");
    EXPECT_EQ(o.errors, "");
    EXPECT_EQ(read_text(scratch.path("a.bin"))[0], count);
  }
  EXPECT_FALSE(exists(scratch.path("a")));  // no port is made
  EXPECT_NE(read_text(scratch.path("t")).find("\"counters\""), std::string::npos);
}

TEST(LockstepProgram, tells_a_wrong_line_and_still_writes_eeprom_files) {
  Scratch scratch;
  const char JSON[] = R"({"boards":[{"name":"a","firmware":"@boot_count","eeprom":"a.bin"}]})";
  Outcome o = emulate(scratch, JSON, "run 160000\nrun x\nrun 320000\n");
  EXPECT_EQ(o.status, 2);
  EXPECT_EQ(o.out, "160000\n");
  EXPECT_EQ(o.errors,
            "javino-emulator: standard input, line 2: expected a cycle, 0 to 9223372036854775807, found \"x\"\n");
  EXPECT_EQ(read_text(scratch.path("a.bin"))[0], '\0');
}

TEST(LockstepProgram, ends_after_its_duration) {
  Scratch scratch;
  Outcome o = emulate(scratch, ECHO_ALONE, "run 16000\nrun 320000\nrun 480000\n", "--duration 0.01");
  EXPECT_EQ(o.status, 0);
  EXPECT_EQ(o.out, "16000\n160000\n");
}

TEST(LockstepProgram, has_no_speed) {
  Scratch scratch;
  Outcome o = emulate(scratch, ECHO_ALONE, "{\"do\":\"speed\",\"value\":2}\nrun 1600\n");
  EXPECT_EQ(o.out, "{\"error\":\"command: there is no speed in lock-step; leave it out\"}\n1600\n");
  EXPECT_EQ(o.status, 0);
}

TEST(LockstepProgram, a_crash_ends_it) {
  Scratch scratch;
  Outcome o = emulate(scratch, R"({"boards":[{"name":"a","firmware":"@crash"}]})", "run 1600000000\n");
  EXPECT_EQ(o.status, 1);
  EXPECT_NE(o.errors.find("its program crashed"), std::string::npos) << o.errors;
}

TEST(LockstepProgram, notes_the_keys_that_hosts_set) {
  Scratch scratch;
  Outcome o = emulate(scratch, ECHO_ALONE, "run 1600\n", "--keys '" + scratch.path("keys") + "'");
  EXPECT_EQ(o.status, 0);
  EXPECT_TRUE(exists(scratch.path("keys")));
}
