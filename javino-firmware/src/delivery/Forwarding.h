#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../framing/Frame.h"
#include "../framing/Limits.h"
#include "../radio/Radio.h"
#include "../support/Counters.h"
#include "../support/Inlining.h"
#include "../support/Part.h"
#include "../support/Random.h"
#include "../support/Trace.h"
#include "../support/Zeroed.h"
#include "Distances.h"
#include "MediumAccess.h"

namespace javinolib {

/// The work of a relay (SPEC 7.5): it copies unicasts that nobody seems to answer, and carries their acknowledgements back;
/// broadcasts and multicasts it copies once. It has no key, and looks at addresses and nonces only.
class Forwarding {
 public:
  struct Memory;

  Forwarding(MediumAccess &medium, Random &random, Counters &counters)
      : medium_(medium), random_(random), counters_(counters), credits_{MOST, MOST} {}

  /// Begins to relay, or ends that.
  /// @param memory for all that a relay knows, cleared; null where it ends
  void relay(Memory *memory) {
    memory_ = memory;
    trace::tell(trace::RELAY_ON, isOn());
  }

  bool isOn() const { return memory_ != nullptr; }

  /// Looks at a packet from the air that is not from this board.
  /// @param packet all of the frame
  /// @param path as SPEC 6 has it, 0…19
  /// @param isForUs whether this board is its destination, so that it is not copied
  void heard(const Frame &frame, const uint8_t *packet, uint8_t length, uint8_t path, bool isForUs = false);

  /// Sends what is due; to be called each time the medium was looked at.
  JAVINO_NOINLINE void run();

 private:
  static const uint8_t CAPACITY = 4;

  // Time on the air in tenths of a millisecond: a relay takes a tenth of all time, so its credit grows by one each millisecond.
  static const uint8_t TENTHS = 10;
  static const uint16_t MOST = 4000u * TENTHS;  // where add() ends

  /// The header of a packet and its nonce, by which it is known when its acknowledgement has taken the place of the rest.
  static const uint8_t HEAD_LENGTH = HEADER_LENGTH + NONCE_LENGTH;
  static const uint8_t MAX_ANSWER = HEADER_LENGTH + 16;

  enum Due : uint8_t { NOTHING, COPY, ANSWER };
  enum Place : uint8_t { PEER, DOWNSTREAM, UPSTREAM };

  struct Entry {
    uint8_t length;      // of the packet, 0 for a free entry
    Due due;             // what waits for the air
    uint8_t first;       // quiet slots in a row that it waits for
    uint8_t left;        // further ones
    uint8_t hops;        // of our copy
    uint8_t distance;    // of its destination plus 1, 0 where that is unknown or of no use
    uint8_t answerHops;  // of our copy of its acknowledgement
    uint8_t answerLength;
    uint8_t answers;  // copies of it since the packet was new or late
    uint8_t quiet;    // slots since the end of our last copy, or since what is in reserve was heard
    bool sending;     // a copy is on the air
    uint8_t toMany;   // 1: a broadcast or multicast
    bool reserve;
    bool fromReserve;
    bool trusted;   // its score was 0 when it began
    bool repeated;  // or need not be
    bool copied;
    bool late;
    bool handedOn;
    bool prompt;  // and soon
    bool answered;
    bool answerHandedOn;
    uint16_t crc;                      // of the packet
    uint16_t to;                       // its destination's number
    uint16_t spent;                    // of the credit
    uint16_t age;                      // milliseconds since something happened to it
    uint8_t bytes[MAX_RADIO_PAYLOAD];  // the packet; once it is answered its head, and behind that the acknowledgement
  };

  static Place placeOf(uint8_t hops, uint8_t own);
  Entry *find(const uint8_t *packet, uint8_t length, uint16_t crc);
  Entry *place();
  void packetHeard(const uint8_t *packet, uint8_t length, uint8_t path, bool toMany);
  bool heardAgain(Entry &entry, uint8_t hops);
  void copyHeard(Entry &entry, uint8_t hops);
  void begin(Entry &entry, uint8_t hops, bool fromReserve, bool isAway = false);
  JAVINO_NOINLINE uint16_t lateMillis(const Entry &entry) const;
  bool isInReserveForScore(const Entry &entry) const;
  void answerHeard(const Frame &frame, const uint8_t *packet, uint8_t length, uint8_t path);
  void firstAnswer(Entry &entry, const uint8_t *packet, uint8_t length, uint8_t path);
  void wait(Entry &entry, Due due, uint8_t first, uint8_t left, trace::Point point);
  JAVINO_NOINLINE static void tell(trace::Point point, const Entry &entry, uint8_t second = 0);
  uint8_t spread(bool turn);
  void passTime();
  JAVINO_NOINLINE uint16_t costOf(uint8_t length) const;
  JAVINO_NOINLINE static void add(uint16_t &sum, uint16_t more);
  void send(Entry &entry);
  void sent(Entry &entry);

  Part<MediumAccess> medium_;
  Part<Random> random_;
  Part<Counters> counters_;
  Memory *memory_ JAVINO_ZEROED;
  uint8_t slots_ JAVINO_ZEROED;  // quiet slots that were counted
  uint16_t credits_[2];          // that may still be spent, for unicasts and for many
  uint16_t lookedAt_ JAVINO_ZEROED;
};

struct Forwarding::Memory {
  Distances distances;
  Entry entries[CAPACITY];
};

/// The substitute for it on a board that cannot be told to relay (Config.h).
class NoForwarding {
 public:
  NoForwarding(MediumAccess &, Random &, Counters &) {}

  struct Memory {};

  void relay(Memory *) {}
  bool isOn() const { return false; }
  void heard(const Frame &, const uint8_t *, uint8_t, uint8_t, bool) {}
  void run() {}
};

#if JAVINO_LARGE
typedef Forwarding BoardsForwarding;
#else
typedef NoForwarding BoardsForwarding;
#endif

}  // namespace javinolib
