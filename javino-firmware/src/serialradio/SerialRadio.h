#pragma once

#include "../board/PortType.h"
#include "../framing/PacketDecoder.h"
#include "../framing/PacketEncoder.h"
#include "../radio/Radio.h"
#include "../support/Core.h"
#include "SerialModule.h"

namespace javinolib {

/// A radio module at a serial port of its own (SPEC 6.2). It takes no timer and no interrupt but the port's; all is done in
/// receive(). On an AVR a global or static object (support/Zeroed.h).
class SerialRadio : public Radio {
 public:
  static const uint8_t NO_PIN = 0xFF;

  /// @param port a UART, as Serial1; begin() opens it
  /// @param module JAVINO_HC_12, JAVINO_E32, JAVINO_E22, or one of your own, in flash
  /// @param auxPin digital pin at the AUX of a module that has one, low while it is busy
  template <typename Port>
  SerialRadio(Port &port, const SerialModule &module, uint8_t auxPin = NO_PIN)
      : SerialRadio(port, PortType<Port>::begin, PortType<Port>::room, module, auxPin) {}

  bool begin() override;
  bool send(const uint8_t *payload, uint8_t length) override;
  bool sending() const override { return sending_; }
  bool carrier() const override;
  uint8_t longestPayload() const override { return flashByte(&module_.longestPayload); }
  uint16_t airtimeMillis(uint8_t length) const override;
  uint8_t slotMillis() const override { return flashByte(&module_.slotMillis); }
  uint8_t *receive(Received &with) override;
  void release() override { waits_ = false; }
  uint8_t *sentPath() override { return &sentPath_; }
  void counters(RadioCounters &into) const override { into = counters_; }
  bool idle() const override;

 private:
  static const uint8_t ROOM = 1 + MAX_RADIO_PAYLOAD + 2;

  SerialRadio(Stream &port, void (*begin)(Stream &, unsigned long), int (*room)(Stream &), const SerialModule &module,
              uint8_t auxPin);

  // On an AVR only SoftwareSerial never tells its room, which will not do.
  bool canWrite() const {
#ifdef __AVR__
    return roomOfPort_(port_) > 0;
#else
    return room_.takes(roomOfPort_(port_));
#endif
  }

  bool isBusy() const;
  void write();
  void read();
  void take(uint8_t byte);

  Stream &port_;
#ifndef __AVR__
  mutable PortRoom room_;
#endif
  void (*const beginPort_)(Stream &, unsigned long);
  int (*const roomOfPort_)(Stream &);
  const SerialModule &module_;
  const uint8_t auxPin_;
  bool sending_ JAVINO_ZEROED;
  mutable bool heard_ JAVINO_ZEROED;  // bytes have come since carrier() was called, or when it was
  bool inPacket_ JAVINO_ZEROED;       // the last byte was not the end of one
  bool overrun_ JAVINO_ZEROED;        // the port had no room for more: bytes may be lost
  bool waits_ JAVINO_ZEROED;          // a packet, for release()
  uint16_t airtime_ JAVINO_ZEROED;    // of the packet that is sent, in ms
  uint16_t sentAt_ JAVINO_ZEROED;
  uint16_t heardAt_ JAVINO_ZEROED;
  uint8_t sentPath_ JAVINO_ZEROED;
  PacketEncoder encoder_;
  PacketDecoder decoder_;
  RadioCounters counters_ JAVINO_ZEROED;
  uint8_t out_[ROOM];
  uint8_t in_[ROOM];
};

}  // namespace javinolib
