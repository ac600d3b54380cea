#pragma once

#include "../framing/Frame.h"
#include "Reply.h"

namespace javino {

/// Performs requests for a SerialSession.
class RequestHandler {
 public:
  /// Performs a request and writes status and body of its reply, which stands at an OK without a body.
  /// @return whether the reply is to be remembered for repeats of the request
  virtual bool perform(const Frame &request, Reply &reply) = 0;

  /// Whether the request is always performed, even if it is byte by byte the one before.
  virtual bool isAlwaysPerformed(const Frame &request) const = 0;

 protected:
  ~RequestHandler() {}
};

}  // namespace javino
