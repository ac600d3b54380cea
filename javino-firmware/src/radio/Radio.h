#pragma once

#include <stdint.h>

namespace javino {

/// The most bytes of payload that one radio packet carries (SPEC 6).
static const uint8_t MAX_RADIO_PAYLOAD = 77;

/// What a radio has seen since it began; each count stops at 4294967295 (SPEC 4.5, counters 5, 6, 7, 17, 28).
struct RadioCounters {
  uint32_t received;  ///< packets with a right CRC, mended ones among them
  uint32_t damaged;   ///< packets with a wrong symbol, count or CRC
  uint32_t missed;    ///< packets that came while no buffer was free
  uint32_t sent;      ///< packets that have been on the air whole
  uint32_t mended;    ///< packets of which one symbol was mended
};

/// A half-duplex packet radio: payloads of 1…77 bytes, as they came from or go to the air (SPEC 6).
///
/// The seam between the board's protocol side and the modem. It is virtual so that the host tests can stand a mock
/// in for the hardware; the price, one table of pointers and an indirect call a packet, is small beside a packet's
/// tens of milliseconds of air. No function blocks.
class Radio {
 public:
  /// Sets pins and timer. From now on it receives whenever it is not sending.
  /// @return false where the pins, the rate or the timer cannot be had.
  virtual bool begin() = 0;

  /// Starts to send a payload, which is copied.
  /// @param length 1…77
  /// @return false, and nothing is sent, while another packet is on the air, where the length is out of range, or while
  /// so many received packets wait that there is no room for it.
  virtual bool send(const uint8_t *payload, uint8_t length) = 0;

  /// @return whether a packet is on the air: false again after its last bit.
  virtual bool sending() const = 0;

  /// @return whether another board's carrier is heard now (SPEC 6, 7.4); false while sending.
  /// Safe to call with interrupts off.
  virtual bool carrier() const = 0;

  /// @return bits a second.
  virtual uint16_t bitRate() const = 0;

  /// The oldest received payload, whose CRC was right, in place: the caller's own until release().
  /// @param length set to its length, 1…77
  /// @return null where none is waiting.
  virtual uint8_t *receive(uint8_t &length) = 0;

  /// Forgets the payload that receive() gave.
  virtual void release() = 0;

  /// Copies the counters, each of them undivided by interrupts.
  virtual void counters(RadioCounters &into) const = 0;

  /// Housekeeping outside of interrupts; to be called often, whenever the CPU has woken up.
  virtual void update() = 0;

  /// @return whether neither update() nor receive() has anything to do: the CPU may sleep until the next interrupt.
  /// Safe to call with interrupts off.
  virtual bool idle() const = 0;

 protected:
  ~Radio() = default;  // radios are never deleted through this class: there is no heap
};

}  // namespace javino
