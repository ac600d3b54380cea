#pragma once

#include <stdint.h>

namespace javinolib {

/// The first byte of each reply (SPEC 4.4).
enum class Status : uint8_t {
  OK = 0,
  NOT_GREETED = 1,       ///< the board has (re)started: say hello first
  UNKNOWN_COMMAND = 2,   ///< no such command in this version: compare the protocol versions
  BAD_ARGUMENT = 3,      ///< the body is not what the command takes
  UNKNOWN_ACTION = 4,    ///< the sketch has no action of this name: see its calls of action()
  ACTION_FAILED = 5,     ///< the sketch's function returned false
  NO_RF_ID = 6,          ///< set an RF id first
  WRONG_ORIGIN = 7,      ///< the frame's origin is not the board's RF id, or not `++++` in a request to the board
  BAD_DESTINATION = 8,   ///< reserved, or the board's own address
  NO_KEY = 9,            ///< no key is stored for this address: set one
  TOO_LONG = 10,         ///< the content has more bytes than MAX_CONTENT_LENGTH, 494 unless Config.h says less
  QUEUE_FULL = 11,       ///< the transmit queue is full, or too many outcomes wait: poll, and try again later
  STORE_FULL = 12,       ///< no place for another key: delete one
  STORE_FAILED = 13,     ///< the EEPROM did not keep what was written: it is worn out
  NONCE_EXHAUSTED = 14,  ///< no nonce is left until the next boot, or, after the last epoch, ever
  BUSY = 15,             ///< messages are under way that this would harm: try again when they have ended
  HAS_KEY = 16,          ///< a key is stored for this address: it gets no session key
  EPOCH_LOST = 17,       ///< keys are stored, but no epoch: raise it above all that the board has had
  MEMORY_DAMAGED = 18,  ///< something, as a rule the stack, ran over the memory of nonces: leave it more RAM, and reset
  NO_RADIO = 19,        ///< the sketch has no radio: make a JavinoRadioBoard
  UNICASTS_ONLY = 20    ///< it has sealed unicasts only: make a JavinoRadioBoard in place of a JavinoUnicastBoard
};

}  // namespace javinolib
