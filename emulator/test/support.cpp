// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <sys/stat.h>

Scratch::Scratch() {
  char name[] = "/tmp/javino-emulator-test-XXXXXX";
  folder = mkdtemp(name);
}

Scratch::~Scratch() {
  std::string command = "rm -rf '" + folder + "'";
  if (std::system(command.c_str()) != 0) ADD_FAILURE() << "cannot remove " << folder;
}

std::string Scratch::write(const std::string &name, const std::string &text) const {
  std::ofstream(path(name)) << text;
  return path(name);
}

std::string read_text(const std::string &path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

bool exists(const std::string &path) {
  struct stat status;
  return lstat(path.c_str(), &status) == 0;
}

json_t *load_vectors(const std::string &name) {
  json_error_t mistake;
  std::string path = std::string(VECTORS_DIR) + "/" + name;
  json_t *root = json_load_file(path.c_str(), 0, &mistake);
  EXPECT_NE(root, nullptr) << path << ": " << mistake.text;
  return root;
}

std::vector<uint8_t> from_hex(const std::string &hex) {
  std::vector<uint8_t> bytes;
  for (size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes.push_back(static_cast<uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}

std::string text_of(const json_t *object, const char *key) {
  const char *text = json_string_value(json_object_get(object, key));
  return text ? text : "";
}

std::string with_programs(std::string json) {
  for (size_t at; (at = json.find('@')) != std::string::npos;) {
    size_t end = json.find('"', at);
    json.replace(at, end - at, PROGRAMS_DIR "/" + json.substr(at + 1, end - at - 1) + ".elf");
  }
  return json;
}

Emulation::Emulation(const Scratch &scratch, const std::string &json, uint64_t seed, bool played)
    : e(), config(), out(), trace_path(scratch.path("trace.jsonl")) {
  char error[512];
  simulator_log_install();
  scenario_context context = {scratch.folder.c_str(), nullptr, 0};
  std::string path = scratch.write("scenario.json", with_programs(json));
  if (scenario_load(&config, path.c_str(), &context, error, sizeof error) != 0) throw std::runtime_error(error);
  out.file = std::fopen(trace_path.c_str(), "w");
  int opened =
      played ? emulation_open_played(&e, &config, seed, &out, nullptr) : emulation_open(&e, &config, seed, &out);
  if (opened != 0) throw std::runtime_error(e.error);
}

Emulation::~Emulation() {
  close();
  for (json_t *event : parsed) json_decref(event);
  std::fclose(out.file);
  scenario_release(&config);
}

void Emulation::close() {
  if (!open) return;
  open = false;
  EXPECT_EQ(emulation_close(&e), 0) << e.error;
}

void Emulation::run_until(double seconds) { ASSERT_EQ(emulation_run(&e, seconds_to_cycles(seconds)), 0) << e.error; }

bool Emulation::run_while_waiting(double seconds, const std::function<bool()> &done) {
  cycles_t end = e.now + seconds_to_cycles(seconds);
  while (e.now < end) {
    emulation_exchange(&e);
    if (done()) return true;
    if (emulation_run(&e, e.now + CYCLES_PER_MS) != 0) return false;
  }
  return false;
}

std::string Emulation::command(const std::string &line) {
  ::command c;
  char error[512] = "";
  int result = command_read(&c, line.data(), line.size(), &config, error, sizeof error);
  if (result == 0) result = emulation_command(&e, &c, error, sizeof error);
  command_release(&c);
  EXPECT_EQ(result == 0, error[0] == '\0');
  return error;
}

std::string Emulation::trace_text() { return read_text(trace_path); }

std::vector<Event> Emulation::events(const std::string &board, const std::string &event) {
  std::vector<Event> found;
  std::istringstream lines(trace_text());
  for (std::string line; std::getline(lines, line);) {
    json_t *fields = json_loads(line.c_str(), 0, nullptr);
    EXPECT_NE(fields, nullptr) << line;
    parsed.push_back(fields);
    Event e = {json_number_value(json_object_get(fields, "t")), text_of(fields, "board"), text_of(fields, "event"),
               fields};
    if (e.event == event && (board.empty() || e.board == board)) found.push_back(e);
  }
  return found;
}
