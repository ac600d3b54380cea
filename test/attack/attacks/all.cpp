#include "attacks/attacks.h"

const std::vector<Attack> &allAttacks() {
  static const std::vector<Attack> ALL = {
      {"each single bit changed", changeEachBit},
      {"each single bit changed, in fragments", changeEachBitOfFragments},
      {"a run of bytes replaced", changeManyBits},
      {"tag and content guessed", guessTags},
      {"cut off or extended", changeLengths},
      {"other addresses", changeAddresses},
      {"sealed with another key", sealWithOtherKeys},
      {"replayed within a boot", replayWithinABoot},
      {"replayed after a reset", replayAcrossResets},
      {"replayed after a loss of power", replayAcrossPowerLoss},
      {"replayed after power failed in an EEPROM write", replayAcrossCutWrites},
      {"damaged copies of frames", damageFrames},
      {"changed copies of damaged frames", imitateFrames},
      {"fragments of several messages mixed", mixFragments},
      {"fragments forged", forgeFragments},
      {"first fragments without end", floodWithFirstFragments},
      {"acknowledgements forged", forgeAcknowledgements},
      {"acknowledgements forged and damaged", forgeDamagedAcknowledgements},
      {"acknowledgements of other messages", replayAcknowledgements},
      {"acknowledgements with floors, forged and replayed", forgeStaleAcknowledgements},
      {"acknowledgements with floors, of a group's member for one multicast", raiseByMulticast},
      {"invented origins of a group's member", inventOrigins},
  };
  return ALL;
}
