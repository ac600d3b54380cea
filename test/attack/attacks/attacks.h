#pragma once

#include "Attack.h"

// Frames that were changed, or made without the key (frames.cpp).
Tally changeEachBit(uint32_t seed, uint64_t tries);
Tally changeEachBitOfFragments(uint32_t seed, uint64_t tries);
Tally changeManyBits(uint32_t seed, uint64_t tries);
Tally guessTags(uint32_t seed, uint64_t tries);
Tally changeLengths(uint32_t seed, uint64_t tries);
Tally changeAddresses(uint32_t seed, uint64_t tries);
Tally sealWithOtherKeys(uint32_t seed, uint64_t tries);

// Genuine frames again (replays.cpp).
Tally replayWithinABoot(uint32_t seed, uint64_t tries);
Tally replayAcrossResets(uint32_t seed, uint64_t tries);
Tally replayAcrossPowerLoss(uint32_t seed, uint64_t tries);
Tally replayAcrossCutWrites(uint32_t seed, uint64_t tries);
Tally inventOrigins(uint32_t seed, uint64_t tries);

// Packets that come damaged to a board that mends them (damage.cpp).
Tally damageFrames(uint32_t seed, uint64_t tries);
Tally imitateFrames(uint32_t seed, uint64_t tries);

// Messages in fragments (fragments.cpp).
Tally mixFragments(uint32_t seed, uint64_t tries);
Tally forgeFragments(uint32_t seed, uint64_t tries);
Tally floodWithFirstFragments(uint32_t seed, uint64_t tries);

// Answers to the board's own messages (answers.cpp).
Tally forgeAcknowledgements(uint32_t seed, uint64_t tries);
Tally forgeDamagedAcknowledgements(uint32_t seed, uint64_t tries);
Tally replayAcknowledgements(uint32_t seed, uint64_t tries);
Tally forgeStaleAcknowledgements(uint32_t seed, uint64_t tries);
Tally raiseByMulticast(uint32_t seed, uint64_t tries);
