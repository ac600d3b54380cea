#pragma once

#include "../support/CoreTypes.h"

namespace javinolib {

/// What a core's `Stream` cannot do, by the type of a port: `Serial1`, USB, Bluetooth, …
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
