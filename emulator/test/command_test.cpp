// SPDX-License-Identifier: GPL-3.0-or-later
// The command itself: exit codes, messages, signals.
#include "support.h"

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <memory>
#include <sstream>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

struct Outcome {
  int status;
  std::string out, err;
};

// Starts the emulator with its output in a file, unless a descriptor for it is given.
pid_t start(const Scratch &scratch, std::vector<std::string> arguments, int out = -1) {
  pid_t child = fork();
  if (child != 0) return child;
  std::vector<char *> argv = {const_cast<char *>(EMULATOR)};
  for (std::string &argument : arguments) argv.push_back(&argument[0]);
  argv.push_back(nullptr);
  if (out < 0) out = open(scratch.path("out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  int err = open(scratch.path("err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(out, 1);
  dup2(err, 2);
  if (chdir(scratch.folder.c_str()) == 0) execv(EMULATOR, argv.data());
  _exit(127);
}

Outcome finish(const Scratch &scratch, pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(scratch.path("out")), read_text(scratch.path("err"))};
}

Outcome run(const Scratch &scratch, std::vector<std::string> arguments) {
  return finish(scratch, start(scratch, arguments));
}

void write_scenario(const Scratch &scratch, const std::string &program, const std::string &more = "") {
  scratch.write("s.json",
                R"({"boards":[{"name":"a","firmware":")" PROGRAMS_DIR "/" + program + ".elf\"" + more + "}]}");
}

}  // namespace

TEST(Command, runs_for_the_duration_and_traces_to_standard_output) {
  Scratch scratch;
  write_scenario(scratch, "blink", R"(,"watch":[{"pin":13,"name":"led"}])");
  Outcome outcome = run(scratch, {"s.json", "--duration", "0.1", "--speed", "max", "--trace", "-"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find(R"("event":"pin","pin":13,"name":"led","level":1})"), std::string::npos);
  EXPECT_NE(outcome.out.find(R"({"t":0.100000,"board":"a","event":"counters")"), std::string::npos);
}

TEST(Command, the_trace_names_a_port_by_what_distinguishes_it) {
  Scratch scratch;
  std::string json = R"({"boards":[)";
  for (const char *port : {"1/usb", "2/usb", "3/other"})
    json += (json.back() == '[' ? "" : ",") + std::string(R"({"firmware":")" PROGRAMS_DIR R"(/blink.elf","name":")") +
            port[0] + R"(","port":")" + port + "\"}";
  scratch.write("s.json", json + "]}");
  Outcome outcome = run(scratch, {"s.json", "--duration", "0.01", "--speed", "max", "--trace", "-"});
  for (const char *port : {"1/usb", "2/usb", "other"})
    EXPECT_NE(outcome.out.find(std::string(R"("port":")") + port + "\""), std::string::npos) << port << outcome.err;
}

TEST(Command, mistakes_are_one_line_and_status_2) {
  Scratch scratch;
  write_scenario(scratch, "blink", R"(,"prot":"x")");
  const std::vector<std::pair<std::vector<std::string>, std::string>> CASES = {
      {{}, "name a scenario file; try --help"},
      {{"s.json"}, "s.json: boards[0]: unknown key \"prot\"; did you mean \"port\"?"},
      {{"none.json"}, "none.json: cannot read the scenario: No such file or directory"},
      {{"s.json", "--trace"}, "--trace needs a value after it; try --help"},
  };
  for (const auto &c : CASES) {
    Outcome outcome = run(scratch, c.first);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "javino-emulator: " + c.second + "\n");
  }
  write_scenario(scratch, "blink");
  Outcome outcome = run(scratch, {"s.json", "--trace", "none/trace"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "javino-emulator: --trace none/trace: No such file or directory\n");
  outcome = run(scratch, {"s.json", "--keys", "none/keys"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "javino-emulator: --keys none/keys: No such file or directory\n");
}

TEST(Command, a_folder_or_an_empty_file_in_the_place_of_a_file_is_called_so) {
  Scratch scratch;
  scratch.write("empty", "");
  write_scenario(scratch, "blink");
  const std::string BLINK = PROGRAMS_DIR "/blink.elf";
  for (const std::string &wrong : {std::string("."), std::string("empty")}) {
    std::string why = wrong == "." ? "it is a folder, not a file\n" : "it is empty\n";
    std::string file = scratch.folder + "/" + wrong;
    EXPECT_EQ(run(scratch, {wrong}).err, "javino-emulator: " + wrong + ": cannot read the scenario: " + why);
    EXPECT_EQ(run(scratch, {"s.json", "--replay", wrong}).err, "javino-emulator: --replay " + wrong + ": " + why);
    scratch.write("w.json", R"({"boards":[{"name":"a","firmware":")" + file + "\"}]}");
    EXPECT_EQ(run(scratch, {"w.json"}).err, "javino-emulator: board a: " + file + ": " + why);
    scratch.write("w.json", R"({"boards":[{"name":"a","firmware":")" + BLINK + R"(","bootLoader":")" + file + "\"}]}");
    EXPECT_EQ(run(scratch, {"w.json", "--duration", "0.01"}).err, "javino-emulator: board a: " + file + ": " + why);
  }
}

TEST(Command, a_byte_order_mark_before_scenario_and_record_is_skipped) {
  Scratch scratch;
  write_scenario(scratch, "blink");
  EXPECT_EQ(run(scratch, {"s.json", "--duration", "0.01", "--speed", "max", "--record", "record"}).status, 0);
  for (const char *name : {"s.json", "record"}) scratch.write(name, "\xEF\xBB\xBF" + read_text(scratch.path(name)));
  Outcome outcome = run(scratch, {"s.json", "--replay", "record"});
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.status, 0);
}

TEST(Command, keys_are_added_to_a_file_that_only_its_user_can_read) {
  Scratch scratch;
  write_scenario(scratch, "blink");
  scratch.write("keys", "# of an earlier run\n");
  EXPECT_EQ(run(scratch, {"s.json", "--duration", "0.01", "--keys", "keys"}).status, 0);
  EXPECT_EQ(read_text(scratch.path("keys")), "# of an earlier run\n");
  struct stat status;
  ASSERT_EQ(stat(scratch.path("keys").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
}

TEST(Command, a_crashed_program_is_status_1) {
  Scratch scratch;
  write_scenario(scratch, "crash");
  Outcome outcome = run(scratch, {"s.json", "--speed", "max", "--trace", "-"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("javino-emulator: board a: its program crashed at pc 0x"), std::string::npos);
  EXPECT_NE(outcome.out.find(R"("board":"a","event":"crash"})"), std::string::npos) << outcome.out;
}

TEST(Command, what_a_program_tells_simavr_to_write_is_not_written) {
  Scratch scratch;
  ASSERT_NE(read_text(PROGRAMS_DIR "/traced.elf").find("stolen.vcd"), std::string::npos);
  write_scenario(scratch, "traced");
  Outcome outcome = run(scratch, {"s.json", "--duration", "0.1", "--speed", "max", "--trace", "-"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find(R"("line":"kept")"), std::string::npos) << outcome.out;
  EXPECT_FALSE(exists(scratch.path("stolen.vcd")));
}

TEST(Command, a_second_emulator_with_the_same_eeprom_file_is_told_so) {
  Scratch scratch, other;
  for (const Scratch *each : {&scratch, &other})
    write_scenario(*each, "boot_count", ",\"eeprom\":\"" + scratch.path("a.bin") + "\"");
  pid_t first = start(scratch, {"s.json", "--trace", "trace"});
  while (read_text(scratch.path("trace")).find("\"reset\"") == std::string::npos) usleep(1000);
  other.write("trace", "of the run before");
  Outcome second = run(other, {"s.json", "--duration", "0.1", "--speed", "max", "--trace", "trace"});
  EXPECT_EQ(second.status, 2);
  EXPECT_EQ(read_text(other.path("trace")), "of the run before");
  EXPECT_EQ(second.err, "javino-emulator: EEPROM file " + scratch.path("a.bin") +
                            ": another emulator or board uses it; end that one or choose another file\n");
  kill(first, SIGTERM);
  EXPECT_EQ(finish(scratch, first).status, 0);
  EXPECT_EQ(run(other, {"s.json", "--duration", "0.1", "--speed", "max"}).status, 0) << "it is free again";
}

TEST(Command, of_emulators_that_make_one_eeprom_file_at_the_same_time_one_has_it) {
  for (int round = 0; round < 10; round++) {
    Scratch file;
    std::vector<std::unique_ptr<Scratch>> scratches;
    std::vector<pid_t> children;
    for (int i = 0; i < 4; i++) {
      scratches.push_back(std::make_unique<Scratch>());
      write_scenario(*scratches.back(), "boot_count", ",\"eeprom\":\"" + file.path("a.bin") + "\"");
      children.push_back(start(*scratches.back(), {"s.json"}));  // until it is told to end
    }
    int refused = 0;
    for (int i = 0; i < 3; i++) {
      int status = 0;
      pid_t ended = waitpid(-1, &status, 0);
      refused += WIFEXITED(status) && WEXITSTATUS(status) == 2;
      children.erase(std::find(children.begin(), children.end(), ended));
    }
    EXPECT_EQ(refused, 3);
    ASSERT_EQ(children.size(), 1u);
    kill(children[0], SIGTERM);
    int status = 0;
    waitpid(children[0], &status, 0);
    EXPECT_EQ(status, 0);
  }
}

TEST(Command, help_is_no_mistake) {
  Scratch scratch;
  Outcome outcome = run(scratch, {"--help"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out.find("usage: javino-emulator SCENARIO.json"), 0u);
}

// Sends a line to the socket and returns the reply.
static std::string told(const std::string &path, const std::string &line) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  snprintf(address.sun_path, sizeof address.sun_path, "%s", path.c_str());
  int client = socket(AF_UNIX, SOCK_STREAM, 0);
  while (connect(client, reinterpret_cast<sockaddr *>(&address), sizeof address) != 0) usleep(1000);
  EXPECT_EQ(write(client, (line + "\n").data(), line.size() + 1), ssize_t(line.size() + 1));
  char reply[1024];
  ssize_t length = read(client, reply, sizeof reply);
  close(client);
  return length > 0 ? std::string(reply, static_cast<size_t>(length)) : "";
}

TEST(Command, the_control_socket_pauses_and_steers_it) {
  const std::string OK = "{\"ok\":true}\n";
  Scratch scratch;
  write_scenario(scratch, "blink");
  pid_t child = start(scratch, {"s.json", "--control", "control", "--trace", "trace"});
  EXPECT_EQ(told(scratch.path("control"), R"({"do":"speed","value":0})"), OK);
  EXPECT_EQ(told(scratch.path("control"), R"({"do":"reset","board":"a"})"), OK);
  EXPECT_EQ(told(scratch.path("control"), R"({"do":"reset","board":"b"})"),
            R"({"error":"command: board: expected the name of one of the boards, found \"b\""})"
            "\n");
  EXPECT_EQ(told(scratch.path("control"), R"({"do":"reset","board":"a"})"), OK);
  EXPECT_EQ(told(scratch.path("control"), R"({"do":"speed","value":100})"), OK);
  kill(child, SIGTERM);
  EXPECT_EQ(finish(scratch, child).status, 0);
  EXPECT_FALSE(exists(scratch.path("control")));
  std::istringstream lines(read_text(scratch.path("trace")));
  std::vector<std::string> cycles;
  for (std::string line; std::getline(lines, line);)
    if (line.find("\"command\"") != std::string::npos)
      cycles.push_back(line.substr(line.find("\"cycle\""), line.find(",\"do\"") - line.find("\"cycle\"")));
  ASSERT_EQ(cycles.size(), 4u);
  for (const std::string &cycle : cycles) EXPECT_EQ(cycle, cycles[0]) << "time stood still";
}

// Acts of a host and commands in a run with all kinds of chance in it; ends when the trace shows the last of them.
static void interfere(const Scratch &scratch) {
  const std::string control = scratch.path("control");
  const std::vector<std::string> lines = {
      R"({"do":"speed","value":0})",
      R"({"do":"jam","duration":0.05,"position":[1,1]})",
      R"({"do":"move","board":"mirror","position":[0.1,20.7],"heading":12.3})",
      R"({"do":"send","position":[3,3],"payload":"2f2f2f2f43414645417748656c6c6f21","flip":3})",
      R"({"do":"speed","value":20})",
      R"({"do":"power-cut","board":"count","duration":0.05})",
      R"({"do":"radio","bitErrorRate":0.004})",
      R"({"do":"radio","noise":{"edges":3000,"after":0.01},"bursts":{"rate":0.01},"capture":3})",
  };
  for (int round = 0; round < 3; round++) {
    int host = open(scratch.path("run/a").c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
    ASSERT_GE(host, 0);
    for (const std::string &line : lines) {
      EXPECT_EQ(told(control, line), "{\"ok\":true}\n");
      ssize_t written = write(host, line.data(), line.size());
      EXPECT_TRUE(written == ssize_t(line.size()) || errno == EAGAIN) << "a host waits while time stands still";
      usleep(3000);
      char bytes[64];
      ssize_t length = round == 1 ? 0 : read(host, bytes, sizeof bytes);  // in round 1 nobody reads
      EXPECT_LE(length, ssize_t(sizeof bytes));
    }
    close(host);
    usleep(100000);  // it notices that at its next look at the port
    EXPECT_EQ(told(control, R"({"do":"unplug","board":"a"})"), "{\"ok\":true}\n");
    EXPECT_EQ(told(control, R"({"do":"plug","board":"a"})"), "{\"ok\":true}\n");
  }
}

TEST(Command, a_recorded_run_is_made_again_to_the_byte) {
  Scratch scratch;
  scratch.write("s.json",
                R"({"radio":{"bitErrorRate":0.001,"errorsByDistance":"outdoors","noise":{},"capture":6},"boards":[
      {"name":"a","firmware":")" PROGRAMS_DIR R"(/uart_echo.elf","port":"a","bridge":{"latency":16},"clockError":4321},
      {"name":"count","firmware":")" PROGRAMS_DIR R"(/boot_count.elf","eeprom":"count.bin"},
      {"name":"sender","firmware":")" PROGRAMS_DIR R"(/rf_send.elf","clockError":-50},
      {"name":"mirror","firmware":")" PROGRAMS_DIR R"(/rf_mirror.elf","path":[[0,[5,5]],[3,[50,50]]]}]})");
  for (int earlier = 0; earlier < 3; earlier++)  // what the EEPROM holds is no round number
    EXPECT_EQ(run(scratch, {"s.json", "--directory", "run", "--duration", "0.1", "--speed", "max"}).status, 0);
  pid_t child = start(scratch, {"s.json", "--directory", "run", "--trace", "trace", "--record", "record", "--control",
                                "control", "--seed", "5", "--set", "radio.range=30", "--set", "radio.capture=0"});
  while (!exists(scratch.path("run/a"))) usleep(1000);
  interfere(scratch);
  kill(child, SIGTERM);
  Outcome live = finish(scratch, child);
  ASSERT_EQ(live.status, 0) << live.err;
  std::string trace = read_text(scratch.path("trace"));
  EXPECT_NE(trace.find("\"injector\""), std::string::npos);
  EXPECT_NE(trace.find("\"closed\""), std::string::npos);
  struct stat status;
  ASSERT_EQ(stat(scratch.path("record").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);

  std::string eeprom = read_text(scratch.path("run/count.bin"));
  Outcome again = run(scratch, {"s.json", "--directory", "run", "--trace", "again", "--replay", "record"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(read_text(scratch.path("again")) == trace, true) << "the traces differ";
  EXPECT_EQ(read_text(scratch.path("run/count.bin")), eeprom);
  EXPECT_FALSE(exists(scratch.path("run/a")));

  // A record that a killed run leaves is good as far as it goes.
  std::string record = read_text(scratch.path("record"));
  size_t header = record.find('\n') + 1;
  scratch.write("record", record.substr(0, header + (record.size() - header) / 2));
  EXPECT_EQ(run(scratch, {"s.json", "--trace", "again", "--replay", "record"}).status, 0);
  std::string part = read_text(scratch.path("again"));
  // The end is its own, and what it cuts off.
  part.resize(std::min(part.find("\"counters\"") - 40, part.find("\"cut\":true")));
  EXPECT_EQ(trace.compare(0, part.rfind('\n'), part, 0, part.rfind('\n')), 0);
}

TEST(Command, a_damaged_record_is_refused_in_one_line_and_never_crashes) {
  Scratch scratch;
  write_scenario(scratch, "uart_echo", R"(,"port":"a")");
  const std::string HEADER = R"({"record":1,"seed":"1","radio":{},"boards":[{"name":"a","eeprom":""}]})"
                             "\n";
  const std::vector<std::pair<std::string, std::string>> CASES = {
      {"", "--replay record: it is empty"},
      {"x\n", "record: line 1, column 1: "},
      {"{\"record\":2}\n", "record: record: expected 1, as this emulator writes it, found 2 (line 1)"},
      {R"({"record":1,"seed":"1","radio":{},"boards":[{"name":"b","eeprom":""}]})"
       "\n",
       R"(record: boards[0].name: the scenario has "a" there; expected the scenario of the recorded run (line 1))"},
      {R"({"record":1,"seed":"1","radio":{},"boards":[{"name":"a","eeprom":"00"}]})"
       "\n",
       "record: boards[0].eeprom: expected 4096 bytes in hexadecimal digits (line 1)"},
      {HEADER + "{\"run\":5000}\n{\"run\":10}\n",
       "record: run: expected a later cycle than that of the line before, found 10 (line 3)"},
      {HEADER + "{\"walk\":1}\n", "record: the object: unknown key \"walk\"; expected one of: run, exchange, command"},
      {HEADER + R"({"exchange":[{"board":"a","port":"same","in":"00","out":0}]})"
                "\n",
       "record: exchange[0]: no host can have done this here; expected the scenario, firmware and emulator of the "
       "recorded run (line 2)"},
      {HEADER + R"({"command":{"do":"rest"}})"
                "\n",
       "record: command: command: do: unknown value"},
  };
  for (const auto &c : CASES) {
    scratch.write("record", c.first);
    Outcome outcome = run(scratch, {"s.json", "--replay", "record"});
    EXPECT_NE(outcome.status, 0) << c.first;
    EXPECT_EQ(outcome.err.find("javino-emulator: " + c.second), 0u) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_EQ(run(scratch, {"s.json", "--replay", "none"}).err,
            "javino-emulator: --replay none: No such file or directory\n");
}

TEST(Command, a_signal_while_its_trace_is_not_read_loses_none_of_it) {
  Scratch scratch;
  write_scenario(scratch, "blink", R"(,"watch":[{"pin":13,"name":"led"}])");
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  pid_t child = start(scratch, {"s.json", "--speed", "max", "--trace", "-"}, ends[1]);
  close(ends[1]);
  for (int waiting = 0, before = 0; waiting == 0 || waiting != before; usleep(100000)) {
    before = waiting;
    ASSERT_EQ(ioctl(ends[0], FIONREAD, &waiting), 0);
  }
  kill(child, SIGTERM);
  usleep(100000);
  std::string trace;
  char part[4096];
  for (ssize_t length; (length = read(ends[0], part, sizeof part)) > 0;) trace.append(part, length);
  close(ends[0]);
  Outcome outcome = finish(scratch, child);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(trace.find("\"counters\""), std::string::npos);
  EXPECT_EQ(trace.back(), '\n');
}

TEST(Command, a_signal_ends_it_cleanly) {
  for (int signal : {SIGTERM, SIGINT}) {
    Scratch scratch;
    write_scenario(scratch, "boot_count", R"(,"port":"ports/a","eeprom":"a.bin")");
    pid_t child = start(scratch, {"s.json", "--directory", "run", "--trace", "trace"});
    while (read_text(scratch.path("trace")).find("\"reset\"") == std::string::npos) usleep(1000);
    EXPECT_TRUE(exists(scratch.path("run/ports/a")));
    kill(child, signal);
    Outcome outcome = finish(scratch, child);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_FALSE(exists(scratch.path("run/ports/a")));
    EXPECT_TRUE(exists(scratch.path("run/a.bin")));
    EXPECT_NE(read_text(scratch.path("trace")).find("\"counters\""), std::string::npos);
  }
}
