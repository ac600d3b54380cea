// attacks --tries N --seed S: each attack in turn, N tries in all at least; one line each on stdout, tab-separated:
// name, tries, accepted, genuine, lost. Exit status 1 where a hostile packet was accepted or a genuine one lost.

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "Attack.h"

namespace {

int misused() {
  std::fputs("usage: attacks --tries N --seed S, both whole numbers from 1\n", stderr);
  return 2;
}

bool number(const char *text, unsigned long long &into) {
  char *end = nullptr;
  into = std::strtoull(text, &end, 10);
  return *end == 0 && into != 0 && *text != '-';
}

}  // namespace

int main(int argc, char **argv) {
  unsigned long long tries = 0, seed = 0;
  if (argc != 5 || std::strcmp(argv[1], "--tries") != 0 || std::strcmp(argv[3], "--seed") != 0) return misused();
  if (!number(argv[2], tries) || !number(argv[4], seed)) return misused();
  bool held = true;
  const uint64_t each = tries / allAttacks().size() + 1;
  for (const Attack &attack : allAttacks()) {
    const Tally tally = attack.run(static_cast<uint32_t>(seed), each);
    std::printf("%s\t%llu\t%llu\t%llu\t%llu\n", attack.name, static_cast<unsigned long long>(tally.tries),
                static_cast<unsigned long long>(tally.accepted), static_cast<unsigned long long>(tally.genuine),
                static_cast<unsigned long long>(tally.lost));
    std::fflush(stdout);
    held = held && tally.accepted == 0 && tally.lost == 0;
  }
  return held ? 0 : 1;
}
