#pragma once

#include <string>

/// The letters of all commands.
inline std::string commandLetters() {
  std::string letters;
#define COMMAND(name, letter, text, boards, writesEeprom, meaning) letters += letter;
#include "board/Commands.def"
#undef COMMAND
  return letters;
}

/// The letters of those that only a board with a radio performs.
inline std::string radioCommandLetters() {
  std::string letters;
#define ANY(letter)
#define RADIO(letter) letters += letter;
#define WHOLE_RADIO(letter) letters += letter;
#define COMMAND(name, letter, text, boards, writesEeprom, meaning) boards(letter)
#include "board/Commands.def"
#undef COMMAND
#undef WHOLE_RADIO
#undef RADIO
#undef ANY
  return letters;
}
