// SPDX-License-Identifier: GPL-3.0-or-later
// The command itself: exit codes, messages, signals.
#include "support.h"

#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

struct Outcome {
    int status;
    std::string out, err;
};

pid_t start(const Scratch &scratch, std::vector<std::string> arguments)
{
    pid_t child = fork();
    if (child != 0)
        return child;
    std::vector<char *> argv = {const_cast<char *>(EMULATOR)};
    for (std::string &argument : arguments)
        argv.push_back(&argument[0]);
    argv.push_back(nullptr);
    int out = open(scratch.path("out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    int err = open(scratch.path("err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(out, 1);
    dup2(err, 2);
    if (chdir(scratch.folder.c_str()) == 0)
        execv(EMULATOR, argv.data());
    _exit(127);
}

Outcome finish(const Scratch &scratch, pid_t child)
{
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(scratch.path("out")), read_text(scratch.path("err"))};
}

Outcome run(const Scratch &scratch, std::vector<std::string> arguments)
{
    return finish(scratch, start(scratch, arguments));
}

void write_scenario(const Scratch &scratch, const std::string &program, const std::string &more = "")
{
    scratch.write("s.json", R"({"boards":[{"name":"a","firmware":")" PROGRAMS_DIR "/" + program + ".elf\"" + more + "}]}");
}

} // namespace

TEST(Command, runs_for_the_duration_and_traces_to_standard_output)
{
    Scratch scratch;
    write_scenario(scratch, "blink", R"(,"watch":[{"pin":13,"name":"led"}])");
    Outcome outcome = run(scratch, {"s.json", "--duration", "0.1", "--speed", "max", "--trace", "-"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find(R"("event":"pin","pin":13,"name":"led","level":1})"), std::string::npos);
    EXPECT_NE(outcome.out.find(R"({"t":0.100000,"board":"a","event":"counters")"), std::string::npos);
}

TEST(Command, mistakes_are_one_line_and_status_2)
{
    Scratch scratch;
    write_scenario(scratch, "blink", R"(,"prot":"x")");
    const std::vector<std::pair<std::vector<std::string>, std::string>> CASES = {
        {{}, "scenario: expected a file; try --help, found \"nothing\""},
        {{"s.json"}, "s.json: boards[0]: unknown key \"prot\"; did you mean \"port\"?"},
        {{"none.json"}, "none.json: cannot read the scenario: No such file or directory"},
        {{"s.json", "--trace"}, "--trace: expected a value after it, found \"nothing\""},
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
}

TEST(Command, a_crashed_program_is_status_1)
{
    Scratch scratch;
    write_scenario(scratch, "crash");
    Outcome outcome = run(scratch, {"s.json", "--speed", "max"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("javino-emulator: board a: its program crashed at pc 0x"), std::string::npos);
}

TEST(Command, help_is_no_mistake)
{
    Scratch scratch;
    Outcome outcome = run(scratch, {"--help"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out.find("usage: javino-emulator SCENARIO.json"), 0u);
}

TEST(Command, a_signal_ends_it_cleanly)
{
    for (int signal : {SIGTERM, SIGINT}) {
        Scratch scratch;
        write_scenario(scratch, "boot_count", R"(,"port":"ports/a","eeprom":"a.bin")");
        pid_t child = start(scratch, {"s.json", "--directory", "run", "--trace", "trace"});
        while (read_text(scratch.path("trace")).find("\"reset\"") == std::string::npos)
            usleep(1000);
        EXPECT_TRUE(exists(scratch.path("run/ports/a")));
        kill(child, signal);
        Outcome outcome = finish(scratch, child);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_FALSE(exists(scratch.path("run/ports/a")));
        EXPECT_TRUE(exists(scratch.path("run/a.bin")));
        EXPECT_NE(read_text(scratch.path("trace")).find("\"counters\""), std::string::npos);
    }
}
