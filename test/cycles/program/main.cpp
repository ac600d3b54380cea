// Runs on the emulated Mega: does what the mailbox asks for, between two writes to TWBR that the test times.

#include <avr/io.h>
#include <string.h>

#include "Line.h"
#include "Mailbox.h"
#include "board/Board.h"
#include "crypto/Cfb128.h"
#include "crypto/Cmac.h"
#include "support/Crc16.h"
#include "radio/AskRadio.h"
#include "radio/ReedSolomon.h"
#include "secure/Envelope.h"

extern "C" void measured_expand(uint8_t *roundKeys, const uint8_t *key);
extern "C" void measured_encrypt(uint8_t *roundKeys, const uint8_t *in, uint8_t *out);

namespace {

using namespace javinolib;

Mailbox mailbox;

// The compiler may not move anything across.
inline void barrier() { __asm__ volatile("" ::: "memory"); }

template <typename Work>
inline void measure(Work work) {
  barrier();
  TWBR = 1;
  barrier();
  work();
  barrier();
  TWBR = 0;
  barrier();
}

DerivedKeys mailboxKeys() {
  DerivedKeys keys;
  memcpy(keys.encryption, mailbox.key, sizeof keys.encryption);
  memcpy(keys.authentication, mailbox.second, sizeof keys.authentication);
  return keys;
}

void encryptBlock() {
  uint8_t roundKeys[176];
  javino_aes128_expand(roundKeys, mailbox.key);
  measured_encrypt(roundKeys, mailbox.bytes, mailbox.bytes);
}

void expandKey() {
  uint8_t roundKeys[176];
  measured_expand(roundKeys, mailbox.key);
}

void deriveKeys() {
  DerivedKeys keys;
  measure([&] { keys.derive(mailbox.key); });
  memcpy(mailbox.bytes, keys.encryption, 16);
  memcpy(mailbox.bytes + 16, keys.authentication, 16);
  memcpy(mailbox.bytes + 32, keys.check, DerivedKeys::CHECK_LENGTH);
}

void cfb(bool decrypting) {
  const Aes128 cipher(mailbox.key);
  Cfb128 stream(cipher, mailbox.second);
  measure([&] {
    if (decrypting) {
      stream.decrypt(mailbox.bytes, mailbox.length);
    } else {
      stream.encrypt(mailbox.bytes, mailbox.length);
    }
  });
}

void computeCmac() {
  const Aes128 cipher(mailbox.key);
  uint8_t tag[16];
  measure([&] { cmac(cipher, mailbox.bytes, mailbox.length, tag); });
  memcpy(mailbox.bytes, tag, sizeof tag);
}

// Keys are expanded as an envelope does it: each in a function of its own.
JAVINO_NOINLINE void expandForCfb(const DerivedKeys &keys) { const Aes128 cipher(keys.encryption); }

JAVINO_NOINLINE void expandForCmac(const DerivedKeys &keys) {
  const Aes128 cipher(keys.authentication);
  const Cmac cmac(cipher);
}

void seal() {
  const DerivedKeys keys = mailboxKeys();
  const Envelope envelope(keys);
  static uint8_t sealed[sizeof mailbox.bytes];
  Frame plain;
  if (Frame::parse(mailbox.bytes, mailbox.length, plain) != FrameError::NONE) return;
  const uint16_t length = static_cast<uint16_t>(Envelope::MIN_FRAME_LENGTH + plain.length);
  Frame::writeHeader(sealed, plain.destination, plain.origin, static_cast<uint16_t>(plain.length + SEAL_LENGTH));
  memcpy(sealed + Envelope::CONTENT_AT, plain.message, plain.length);
  measure([&] { envelope.seal(sealed, length, mailbox.nonce); });
  memcpy(mailbox.bytes, sealed, length);
  mailbox.length = length;
}

void open() {
  const DerivedKeys keys = mailboxKeys();
  const Envelope envelope(keys);
  uint16_t content = 0xFFFF;
  measure([&] {
    if (envelope.isAuthentic(mailbox.bytes, mailbox.length)) content = envelope.open(mailbox.bytes, mailbox.length);
  });
  mailbox.length = content;
}

void addToCrc() {
  Crc16 crc;
  measure([&] { crc.add(mailbox.bytes, mailbox.length); });
  mailbox.bytes[0] = static_cast<uint8_t>(crc.value());
  mailbox.bytes[1] = static_cast<uint8_t>(crc.value() >> 8);
}

// The only one: two with their kept packets would not fit.
AskRadio &modem() {
  static AskRadio radio;
  return radio;
}

// All interrupts that a packet makes: an edge each where the line changes, and the alarms at its end.
void hearPacket() {
  AskRadio &radio = modem();
  static uint8_t levels[126];  // one bit each: 84 + 12 * 77
  radio.begin();
  uint8_t packet[MAX_RADIO_PAYLOAD + linecode::PACKET_OVERHEAD + linecode::TRAILER_LENGTH];
  RadioEncoder encoder;
  encoder.start(mailbox.bytes, static_cast<uint8_t>(mailbox.length), Trailer::NONE, packet);
  uint16_t bits = 0;
  for (; encoder.hasNext(); bits++) {
    const uint8_t mask = static_cast<uint8_t>(1 << bits % 8);
    levels[bits / 8] = static_cast<uint8_t>(encoder.next() ? levels[bits / 8] | mask : levels[bits / 8] & ~mask);
  }
  measure([&] {
    bool level = false;
    for (uint16_t i = 0; i <= bits; i++) {
      const bool next = i < bits && (levels[i / 8] >> i % 8 & 1);
      if (next != level) radio.onEdge(static_cast<uint16_t>(i * 1000), next);
      level = next;
    }
    radio.onAlarm();
    radio.onAlarm();
  });
  Received with = {0, 0};
  const uint8_t *payload = radio.receive(with);
  if (payload != nullptr) memcpy(mailbox.bytes, payload, with.length);
  mailbox.length = with.length;
}

#if JAVINO_LARGE

// A packet of which each so many-th symbol has a wrong bit, from the given one on.
void makeDamaged(RadioPacket &packet, uint8_t distance, uint8_t first) {
  uint8_t room[MAX_RADIO_PAYLOAD + linecode::PACKET_OVERHEAD + linecode::TRAILER_LENGTH];
  RadioEncoder encoder;
  encoder.start(mailbox.bytes, static_cast<uint8_t>(mailbox.length), Trailer::NONE, room);
  for (uint8_t skip = linecode::PREAMBLE_SYMBOLS * linecode::BITS_PER_SYMBOL; skip != 0; skip--) encoder.next();
  packet = RadioPacket();
  memset(packet.room, 0, sizeof packet.room);
  for (uint16_t bits = 0; encoder.hasNext(); bits++) {
    packet.symbols = static_cast<uint8_t>(bits / linecode::BITS_PER_SYMBOL);
    const bool wrong =
        bits % linecode::BITS_PER_SYMBOL == 0 && packet.symbols >= 2 && packet.symbols % distance == first % distance;
    if (encoder.next() != wrong) packet.room[bits / 8] |= static_cast<uint8_t>(1 << bits % 8);
  }
  packet.symbols++;
}

void mendPacket() {
  static RadioPacket packet;
  Mender &mender = *modem().mender();
  Mender::Progress progress = Mender::PENDING;
  for (uint8_t i = 0; i <= mailbox.nonce[2]; i++) {
    makeDamaged(packet, mailbox.nonce[1], i);
    mender.begin();
    uint8_t steps = i == mailbox.nonce[2] ? mailbox.nonce[0] : 100;
    while (steps-- != 0) mender.step(packet);
  }
  measure([&] { progress = mender.step(packet); });
  mailbox.length = static_cast<uint8_t>(progress);
}

void addParity() {
  static uint8_t parity[reedsolomon::PARITY_LENGTH];
  measure([] { reedsolomon::encode(mailbox.bytes, static_cast<uint8_t>(mailbox.length), parity); });
  memcpy(mailbox.bytes, parity, sizeof parity);
}

void erase(reedsolomon::Decoder &decoder) {
  decoder.begin(mailbox.bytes, static_cast<uint8_t>(mailbox.length));
  for (uint8_t i = 0; i < mailbox.measured; i++) decoder.erase(mailbox.second[i]);
}

void mendStep() {
  static reedsolomon::Decoder decoder;
  erase(decoder);
  for (uint8_t i = 0; i < mailbox.nonce[0]; i++) decoder.step();
  reedsolomon::Progress progress;
  measure([&] { progress = decoder.step(); });
  mailbox.length = static_cast<uint8_t>(progress);
}

#endif

const uint8_t PERCEPTS = config::LARGE ? 40 : 20;
const char PIN_NAME[] JAVINO_FLASH = "pin";
const FlashText *const PIN = reinterpret_cast<const FlashText *>(PIN_NAME);

// Percepts of a name and a number as sketches have them: as many as a reply holds.
void perceive(Percepts &percepts) {
  for (uint8_t i = 0; i < PERCEPTS; i++) percepts.add(PIN, 1000 + i);
}

void answer() {
  static Board board(SerialPort(reinterpret_cast<Stream &>(line)), "test 1.0");
  board.poll().setSource(perceive);
  const uint16_t before = mailbox.measured == 0 ? 0 : mailbox.length - mailbox.measured;
  line.in = mailbox.bytes;
  line.end = mailbox.bytes + before;
  line.out = nullptr;
  board.run();
  line.end = mailbox.bytes + mailbox.length;
  line.out = mailbox.bytes;
  line.measured = true;
  barrier();
  TWBR = 1;
  barrier();
  board.run();
  mailbox.length = static_cast<uint16_t>(line.out - mailbox.bytes);
}

void perform() {
  switch (mailbox.operation) {
    case Mailbox::NOTHING: measure([] {}); break;
    case Mailbox::EXPAND_KEY: expandKey(); break;
    case Mailbox::ENCRYPT_BLOCK: encryptBlock(); break;
    case Mailbox::DERIVE_KEYS: deriveKeys(); break;
    case Mailbox::ENCRYPT_CFB: cfb(false); break;
    case Mailbox::DECRYPT_CFB: cfb(true); break;
    case Mailbox::COMPUTE_CMAC: computeCmac(); break;
    case Mailbox::EXPAND_KEYS: {
      const DerivedKeys keys = mailboxKeys();
      measure([&] {
        expandForCfb(keys);
        expandForCmac(keys);
      });
      break;
    }
    case Mailbox::SEAL: seal(); break;
    case Mailbox::OPEN: open(); break;
    case Mailbox::ADD_TO_CRC: addToCrc(); break;
    case Mailbox::HEAR_PACKET: hearPacket(); break;
    case Mailbox::ANSWER: answer(); break;
#if JAVINO_LARGE
    case Mailbox::MEND_PACKET: mendPacket(); break;
    case Mailbox::ADD_PARITY: addParity(); break;
    case Mailbox::ERASE: {
      static reedsolomon::Decoder decoder;
      measure([] { erase(decoder); });
      break;
    }
    case Mailbox::MEND_STEP: mendStep(); break;
#endif
    default: break;
  }
}

}  // namespace

int main() {
  const uint16_t address = reinterpret_cast<uint16_t>(&mailbox);
  TWAR = static_cast<uint8_t>(address);
  TWAR = static_cast<uint8_t>(address >> 8);
  for (;;) {
    barrier();
    TWAMR = 1;  // the test reads and writes the mailbox now
    barrier();
    perform();
  }
}
