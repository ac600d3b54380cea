#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../framing/Address.h"
#include "../framing/Limits.h"
#include "../storage/KeyStore.h"
#include "../storage/Retained.h"
#include "../support/Inlining.h"
#include "../support/Zeroed.h"
#include "../support/Part.h"

namespace javinolib {

struct Floor;

/// Remembers for each key and origin the highest nonce that the host has taken (SPEC 5.1), over reboots too. It never
/// forgets an origin to make room for another, since whoever can replay could make it forget.
///
/// Of a pair's key there is one origin, and a place is kept for it. Of a group's key there are as many as its members
/// claim to be: groups share the other places evenly, so that no member can fill those of pairs or of another group.
///
/// A session key (KeyStore.h) has a place of its own too, and no floor.
///
/// The exact nonce is in RAM that a reset leaves alone (Retained.h), behind a CRC and the boot epoch: it is taken over
/// only by the very next boot, so that no old image, which another sketch has left where it was, makes the board forget.
/// The CRC, and a canary between that RAM and the stack, are looked at each time: where they do not hold, everything is
/// refused until the next boot, which goes by the floors.
/// A floor, never lower than any nonce that was accepted, is in EEPROM: all that counts when the RAM is lost. It is there
/// twice, so that no one cell that decays opens the door to replays.
///
/// Wear of the floors. A write raises a floor by 32 sealed frames of its origin (those that go to others count too, as a
/// sender has one counter), goes to the next place of a ring that is free and then erases the old floor, of which a cut
/// of power between the two leaves both, and the higher counts. So each use writes the seals of a place twice: of
/// cells good for 100 000 writes, a place is good for 50 000 uses. With the defaults of Config.h at least 96 - 24 places
/// are free: 72 * 50 000 * 32 = 115 million frames, at one a second for 3.6 years. Places that are worn out are passed
/// over. The ring is begun at another free place in each boot.
class ReplayMemory {
 public:
  enum Verdict : uint8_t {
    NEWER,        ///< higher than all that were taken
    REPEATED,     ///< the last one taken
    REPLAYED,     ///< lower
    BELOW_FLOOR,  ///< not above it, and what was taken is no longer known exactly
    FULL,         ///< from an origin that there is no room to remember
    DAMAGED       ///< the memory does not hold: whether it is one of the others is not known
  };

  explicit ReplayMemory(const KeyStore &keys) : keys_(keys) {}

  /// Reads the floors, takes over what RAM still holds, and forgets what came under keys that are gone. To be called once,
  /// after a boot, when the epoch was raised and the keys were read: a few ms, and 20 ms for each forgotten floor.
  /// @param epoch the boot epoch
  /// @return false where the stack is over the memory, or was in the boot before
  bool begin(uint32_t epoch);

  /// Floors may be lost, since others in EEPROM are: from now on what comes under a stored key is refused, other than above
  /// a floor that is there. It stays so until the key is deleted.
  template <typename Scope = WholeScope>
  void doubtFloors();

  /// Whether what comes under a key from an origin without a floor is refused.
  JAVINO_NOINLINE bool isDoubtful(uint8_t key) const;

  /// @param key the place of the key in the key store
  /// @param nonce 6 bytes
  template <typename Scope = WholeScope>
  JAVINO_NOINLINE Verdict judge(uint8_t key, const Address &origin, const uint8_t *nonce) const;

  /// Makes sure that the floor in EEPROM is not below a nonce that was judged NEWER, before anything comes of it: some
  /// 110 ms for the first of 32, else nothing. Under a session key it only takes the origin's place.
  /// @return false where there is no room for another origin or EEPROM does not keep it: then the nonce must be refused.
  template <typename Scope = WholeScope>
  JAVINO_NOINLINE bool reserve(uint8_t key, const Address &origin, const uint8_t *nonce);

  /// Takes note that the host has taken the message of a nonce for which reserve() was called. The highest stays; where
  /// the key was forgotten meanwhile, nothing happens.
  template <typename Scope = WholeScope>
  JAVINO_NOINLINE void remember(uint8_t key, const Address &origin, const uint8_t *nonce);

  /// Tells the floor in EEPROM: all zeroes where there is none.
  /// @param into room for 6 bytes
  void floor(uint8_t key, const Address &origin, uint8_t *into) const;

  /// Forgets all that came under a key, in EEPROM too: 20 ms for each origin.
  /// @return false where the EEPROM did not erase a floor. That may refuse messages under a later key in the same place,
  /// but never lets one in.
  JAVINO_NOINLINE bool forget(uint8_t key);

  /// Forgets all that came under keys that are gone.
  /// @return false where the EEPROM did not erase a floor.
  bool forgetLostKeys();

  /// Whether one more key of a pair can have its place.
  bool hasPlaceForPair() const {
    const Groups groups = this->groups(NO_PLACE);
    return groups.origins < groups.places;
  }

 private:
  enum State : uint8_t {
    FREE,           // no entry
    NOTHING_TAKEN,  // and nothing lost
    EXACT,          // nonce is the highest taken
    LOST            // nonce was the floor after the boot: what was taken is not above it
  };

  // The groups' part of the memory.
  struct Groups {
    uint8_t keys;
    uint8_t places;   // that are not kept for pairs
    uint8_t origins;  // that are remembered
    uint8_t own;      // of these, by one key
  };

  static const uint8_t NO_PLACE = 0xFF;

  bool takeOverRam(uint32_t epoch);
  void readFloors();
  void takeOverFloor(uint8_t place, const OriginNonce &floor);
  void beginRing(uint32_t epoch);
  JAVINO_NOINLINE bool isInForce(uint8_t place) const;
  JAVINO_NOINLINE static TakenNonce *find(uint8_t key, const Address &origin);
  static TakenNonce *findFree(uint8_t key);
  template <typename Scope>
  bool hasRoom(uint8_t key) const;
  JAVINO_NOINLINE Groups groups(uint8_t key) const;
  uint8_t store(Floor &floor);
  bool isCovered(const TakenNonce &entry, const uint8_t *nonce) const;
  static TakenNonces &memory() { return retained::takenNonces(); }

  Part<const KeyStore> keys_;
  uint8_t nextPlace_ JAVINO_ZEROED;  // of the ring, where to look for a free one
};

#ifdef __AVR__
template <>
ReplayMemory &Part<ReplayMemory>::the();
#endif

}  // namespace javinolib
