#pragma once

#include <stdint.h>

namespace javino {

/// The most bytes of payload that one radio packet carries (SPEC 6). The buffers have room for so many: the driver of a
/// module that could carry more says this.
static const uint8_t MAX_RADIO_PAYLOAD = 77;

/// The fewest bytes that a radio must be able to carry: an acknowledgement (SPEC 7.3), or the header of a piece before that of
/// its frame and the nonce.
static const uint8_t MIN_RADIO_PAYLOAD = 26;

/// What a radio has seen since it began; each count stops at 4294967295 (SPEC 4.5, counters 5, 6, 7, 17, 28).
struct RadioCounters {
  uint32_t received;  ///< packets with a right CRC, mended ones among them
  uint32_t damaged;   ///< packets with a wrong symbol, count or CRC
  uint32_t missed;    ///< packets that came while no buffer was free
  uint32_t sent;      ///< packets that have been on the air whole
  uint32_t mended;    ///< packets of which one symbol was mended
};

/// A half-duplex packet radio: payloads as they came from or go to the air. What carries them, and how fast, only the
/// driver knows. No function blocks.
///
/// The seam between the board's protocol side and the modem. It is virtual so that a sketch can bring a driver of its own,
/// and the host tests a mock; the price, one table of pointers and an indirect call a packet, is small beside a packet's
/// tens of milliseconds of air.
class Radio {
 public:
  /// Starts the hardware. From now on it receives whenever it is not sending.
  /// @return false where that cannot be had, such as its pins.
  virtual bool begin() = 0;

  /// Starts to send a payload, which is copied.
  /// @param length 1…longestPayload()
  /// @return false, and nothing is sent, while another packet is on the air, where the length is out of range, or while
  /// so many received packets wait that there is no room for it.
  virtual bool send(const uint8_t *payload, uint8_t length) = 0;

  /// @return whether a packet is on the air: false again after its last bit.
  virtual bool sending() const = 0;

  /// @return whether another board's carrier is heard now (SPEC 6, 7.4); false while sending.
  /// Safe to call with interrupts off.
  virtual bool carrier() const = 0;

  /// @return the most bytes of a payload, MIN_RADIO_PAYLOAD…MAX_RADIO_PAYLOAD. The same on all boards in reach, as it is
  /// the length of pieces (SPEC 7.1).
  virtual uint8_t longestPayload() const = 0;

  /// @return how long a packet with so many bytes of payload is on the air, in ms.
  virtual uint16_t airtimeMillis(uint8_t length) const = 0;

  /// @return the slot of channel access (SPEC 7.4), 1…255 ms: by then a carrier that has begun is heard.
  virtual uint8_t slotMillis() const = 0;

  /// The oldest received payload, which is not damaged, in place: the caller's own until release(). It is called often,
  /// whenever the CPU has woken up: the place for what a driver does outside of interrupts.
  /// @param length set to its length, 1…longestPayload()
  /// @return null where none is waiting.
  virtual uint8_t *receive(uint8_t &length) = 0;

  /// Forgets the payload that receive() gave.
  virtual void release() = 0;

  /// Copies the counters, each of them undivided by interrupts.
  virtual void counters(RadioCounters &into) const = 0;

  /// @return whether receive() has nothing to do: the CPU may sleep until the next interrupt.
  /// Safe to call with interrupts off.
  virtual bool idle() const = 0;

 protected:
  ~Radio() = default;  // radios are never deleted through this class: there is no heap
};

}  // namespace javino
