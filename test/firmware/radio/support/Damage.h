#pragma once

#include <random>

#include "support/Modem.h"
#include "support/ReferencePacket.h"

// Each bit wrong with this probability.
inline Bits damaged(Bits bits, double rate, std::mt19937 &random) {
  std::geometric_distribution<size_t> distance(rate);
  for (size_t i = distance(random); i < bits.size(); i += 1 + distance(random)) bits[i].flip();
  return bits;
}

// A decoder with a mender behind it: what an AskRadio has between the line and the loop.
class MendingDecoder {
 public:
  MendingDecoder() : decoder_(1000) {}

  void add(const Bits &bits) {
    for (bool bit : bits) decoder_.add(bit);
  }

  // The bits, and the silence that ends them.
  void addAll(const Bits &bits) {
    add(bits);
    add(Bits(10, false));
    decoder_.endOfSignal();
  }

  // The fate of the oldest packet that waits; LOST if none does.
  javinolib::Mender::Progress take() {
    payload = Bytes();
    javinolib::RadioQueue &queue = decoder_.queue();
    javinolib::RadioPacket *packet = queue.oldest();
    if (packet == nullptr) return javinolib::Mender::LOST;
    mender.begin();
    javinolib::Mender::Progress progress;
    steps = 0;
    do {
      progress = mender.step(*packet);
      steps++;
    } while (progress == javinolib::Mender::PENDING && steps < 1000);
    if (progress == javinolib::Mender::WHOLE) {
      payload = Bytes(packet->payload(), packet->payload() + packet->payloadLength());
      if (keeps) mender.keep();
    }
    queue.release();
    return progress;
  }

  bool isEmpty() const { return decoder_.queue().empty(); }

  bool keeps = false;
  int steps = 0;
  Bytes payload;
  javinolib::Mender mender;

 private:
  javinolib::RadioDecoder decoder_;
};

// The fates of packets with random bit errors: they come intact, or mended without a doubt, or are lost, or - never - come
// wrong without a doubt.
struct Damage {
  unsigned packets = 0, untouched = 0, intact = 0, mended = 0, doubtful = 0, wrong = 0;

  unsigned damaged() const { return packets - untouched; }

  void tryPacket(const Bytes &payload, double rate, std::mt19937 &random) {
    const Bits bits = reference::packetBits(payload);
    const Bits came = ::damaged(bits, rate, random);
    packets++;
    if (came == bits) untouched++;
    decoder_.addAll(came);
    while (!decoder_.isEmpty()) {
      if (decoder_.take() != javinolib::Mender::WHOLE) continue;
      const bool isDoubtful = decoder_.mender.isDoubtful();
      unsigned &counter = isDoubtful                    ? doubtful
                          : decoder_.payload != payload ? wrong
                          : decoder_.mender.hasMended() ? mended
                                                        : intact;
      counter++;
    }
  }

 private:
  MendingDecoder decoder_;
};
