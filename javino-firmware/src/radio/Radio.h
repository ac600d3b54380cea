#pragma once

#include <stdint.h>

#include "../Config.h"

namespace javinolib {

/// The most bytes of payload in one radio packet (SPEC 6). The buffers have room for so many, so the driver of a module
/// that can carry more gives this number.
static const uint8_t MAX_RADIO_PAYLOAD = 77;

/// The fewest bytes that a radio must be able to carry: an acknowledgement (SPEC 7.3), or the header of a fragment before that of
/// its frame and the nonce.
static const uint8_t MIN_RADIO_PAYLOAD = 26;

/// Packets tell hops and distances modulo this (SPEC 7.5), in a path (SPEC 6) below PATHS.
static const uint8_t HOPS_MODULUS = 4;
static const uint8_t PATHS = HOPS_MODULUS * (1 + HOPS_MODULUS);

class Mender;

/// The trailer that follows a packet (SPEC 6.1).
enum class Trailer : uint8_t {
  NONE,
  MARK,   ///< a word: the sender understands trailers
  PARITY  ///< another word, and the packet's parity
};

/// The counts of a radio since it began (SPEC 4.5, counters 5, 6, 7, 17, 28, 41 to 43).
struct RadioCounters {
  config::Count received;     ///< packets with a right CRC, mended ones too
  config::Count damaged;      ///< packets with a wrong symbol, count or CRC
  config::Count missed;       ///< packets that came while no buffer was free
  config::Count sent;         ///< packets that have been on the air whole
  config::Count mended;       ///< packets that came damaged and were mended
  config::Count lateMicros;   ///< how late its interrupt began at most, 0 where it has none
  config::Count airtime;      ///< the board counts it, no driver
  config::Count airtimeWait;  ///< seconds until an airtime limit lets a new message go
};

/// The facts that come with a payload.
struct Received {
  uint8_t length;  ///< of the payload, 1…longestPayload()
  uint8_t path;    ///< of the packet (SPEC 6), less than PATHS; 0 where the driver cannot tell that
};

/// A half-duplex packet radio: it sends and receives payloads. Only the driver knows how, and how fast. No function
/// blocks.
///
/// This is the interface between the board's protocol and the modem. It is virtual so that a sketch can have its own
/// driver, and the host tests a mock. The price, one table of pointers and an indirect call a packet, is small beside
/// the tens of milliseconds of a packet.
class Radio {
 public:
  /// Starts the hardware. From then on it receives whenever it is not sending.
  /// @return false if the hardware cannot be used, for example its pins.
  virtual bool begin() = 0;

  /// Starts to send a payload, which is copied.
  /// @param length 1…longestPayload()
  /// @return false, and nothing is sent, if another packet is on the air, if the length is out of range, or if so many
  /// received packets wait that there is no room for this one.
  virtual bool send(const uint8_t *payload, uint8_t length) = 0;

#if JAVINO_LARGE
  /// Says what follows the next packet. A driver need not do that.
  /// @param length of its payload
  /// @return how many bytes of payload would take as long, 0…17; 0 where nothing follows
  virtual uint8_t follow(Trailer, uint8_t length) {
    (void)length;
    return 0;
  }
#endif

  /// @return where to say the path of the packets that are sent from now on, less than PATHS, at first 0; null if the driver
  /// cannot tell that to other boards: then the board is no relay.
  virtual uint8_t *sentPath() { return nullptr; }

  /// @return what knows how the packet that receive() returned has come, and which packets were lost; null where the driver
  /// gives intact ones only.
  virtual Mender *mender() { return nullptr; }

  /// @return whether this board has a packet on the air; false again after its last bit.
  virtual bool sending() const = 0;

  /// @return whether another board's carrier is heard (SPEC 6, 7.4), or was since the last call. The loop may be busy for longer
  /// than a packet lasts, for example with an EEPROM, so a driver that hears in interrupts remembers it.
  virtual bool carrier() const = 0;

  /// @return the most bytes of a payload, MIN_RADIO_PAYLOAD…MAX_RADIO_PAYLOAD. It must be the same on all boards in
  /// range, as it sets the length of fragments (SPEC 7.1).
  virtual uint8_t longestPayload() const = 0;

  /// @return the time of a packet with this many bytes of payload on the air, in ms.
  virtual uint16_t airtimeMillis(uint8_t length) const = 0;

  /// @return the slot of channel access (SPEC 7.4), 1…255 ms: after this time a carrier that has begun is heard.
  virtual uint8_t slotMillis() const = 0;

  /// The oldest undamaged payload received, in place: it belongs to the caller until release(). This is called often,
  /// whenever the CPU has woken up, so a driver can do its work outside of interrupts here.
  /// @param with set where a payload is returned
  /// @return null if none is waiting.
  virtual uint8_t *receive(Received &with) = 0;

  /// Drops the payload that receive() returned.
  virtual void release() = 0;

  /// Copies the counters, 0 for those that it does not count; no interrupt changes one during its copy.
  virtual void counters(RadioCounters &into) const = 0;

  /// @return whether receive() has nothing to do: the CPU may sleep until the next interrupt.
  /// Safe to call with interrupts off.
  virtual bool idle() const = 0;

 protected:
  ~Radio() = default;  // radios are never deleted through this class: there is no heap
};

}  // namespace javinolib
