#include "Wycheproof.h"

#include <sys/stat.h>

#include <fstream>
#include <stdexcept>

#include "Vectors.h"

namespace {

const char SOURCE[] = "Wycheproof aes_cmac";

// The columns are those of verdict.Row in Java.
void leaveRow(const std::string &part, int cases, int run, int right) {
  mkdir("verdict", 0777);
  std::string name = part;
  for (char &c : name) c = c == ' ' || c == '`' ? '-' : c;
  std::ofstream row("verdict/" + name + ".row");
  row << "| " << SOURCE << " | 0.7.0 | " << part << " | " << cases << " | " << run << " | " << right << " | "
      << run - right << " | " << cases - run << " not run, as our keys have 16 bytes |\n";
  if (!row.flush()) throw std::runtime_error("no row can be written");
}

}  // namespace

std::string wronglyJudgedCmacs(const std::string &part,
                               const std::function<Bytes(const Bytes &key, const Bytes &message)> &cmac) {
  int cases = 0;
  int run = 0;
  int right = 0;
  std::string wrong;
  for (const Vector &group : vectors("../verdict/vectors/wycheproof/aes_cmac_test.json", "testGroups")) {
    for (const Vector &test : group.vectors("tests")) {
      cases++;
      if (group.number("keySize") != 128) continue;
      run++;
      const bool taken = cmac(test.bytes("key"), test.bytes("msg")) == test.bytes("tag");
      if (taken == (test.text("result") == "valid")) {
        right++;
      } else {
        wrong += " " + std::to_string(test.number("tcId"));
      }
    }
  }
  leaveRow(part, cases, run, right);
  return wrong;
}
