#pragma once

#include "../support/CoreTypes.h"

namespace javinolib {

/// Whether a port takes a byte without waiting. Ports of some cores, and SoftwareSerial, never tell how much room there is; one
/// that has told none so far takes bytes all the same.
class PortRoom {
 public:
  /// @param room what the port tells now
  bool takes(int room) {
    if (room > 0) tells_ = true;
    return room > 0 || !tells_;
  }

 private:
  bool tells_ = false;
};

/// The methods that a core's `Stream` lacks, by the type of a port: `Serial1`, USB, Bluetooth, …
template <typename Port>
class PortType {
 public:
  static void begin(Stream &port, unsigned long baud) { static_cast<Port &>(port).begin(baud); }

  /// How many bytes the port takes without waiting. Where the core cannot tell, the port takes each, and may wait.
  static int room(Stream &port) { return roomOf(static_cast<Port &>(port), 0); }

 private:
  template <typename Telling>
  static auto roomOf(Telling &port, int) -> decltype(port.availableForWrite()) {
    return port.availableForWrite();
  }

  template <typename Silent>
  static int roomOf(Silent &, long) {
    return 1;
  }
};

}  // namespace javinolib
