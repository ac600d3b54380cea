#include "FragmentReceiver.h"

#include "../secure/Envelope.h"
#include "../support/Clock.h"
#include "../support/Trace.h"
#include "Fragments.h"

namespace javinolib {

static const uint8_t INDEX_MASK = MAX_FRAGMENTS - 1;
static const uint8_t INDEXES = MAX_FRAGMENTS + fragments::WANTS_ANSWER;

static const uint16_t LEAST_EXPIRY_MILLIS = 5000;
static const uint8_t EXPIRY_PACKETS = 8;

void FragmentReceiver::begin(const MediumAccess &medium) {
  const uint8_t longest = static_cast<uint8_t>(HEADER_LENGTH + medium.fragmentLength());
  expiryMillis_ = static_cast<uint16_t>(EXPIRY_PACKETS * medium.airtimeMillis(longest));
  if (expiryMillis_ < LEAST_EXPIRY_MILLIS) expiryMillis_ = LEAST_EXPIRY_MILLIS;
}

template <typename Scope>
bool FragmentReceiver::accept(const Frame &fragment, uint8_t longest, uint16_t age, bool isDoubtful) {
  const uint16_t now = static_cast<uint16_t>(clock::millis());
  const uint8_t id = fragments::idOf(fragment.destination);
  const uint8_t index = fragments::indexOf(fragment.destination);
  const uint8_t at = index & INDEX_MASK;
  const bool wantsAnswer = (index & fragments::WANTS_ANSWER) != 0;
  Frame whole;
  if (index >= INDEXES || fragment.length == 0 || (at == 0 && !startsFrame(fragment, longest, whole))) {
    return acceptor_->drop(Counter::RADIO_FRAGMENTS_DROPPED);
  }
  if (at == 0 ? !isWanted<Scope>(fragment, id, whole, wantsAnswer, now) : ignored_.covers(fragment.origin, id, now))
    return false;
  if (isDoubtful && !isSealed(fragment, id, at)) return acceptor_->drop(Counter::RADIO_DOUBTFUL);
  PartialFrame *partial = placeFor(fragment.origin, id, longest, at == 0, static_cast<uint16_t>(now - age));
  if (partial == nullptr || !partial->add(at, fragment.message, static_cast<uint8_t>(fragment.length), now)) {
    return acceptor_->drop(Counter::RADIO_FRAGMENTS_DROPPED);
  }
  trace::tell(trace::FRAGMENT);
  finish(*partial, now);
  if (wantsAnswer && partial->hasFirst()) answer(acceptor_, *partial);
  return true;
}

// Whether a fragment is known to be of a sealed frame: the first fragment tells.
bool FragmentReceiver::isSealed(const Frame &fragment, uint8_t id, uint8_t index) {
  const PartialFrame *const partial = index == 0 ? nullptr : reassembly_.find(fragment.origin, id);
  if (index != 0 && (partial == nullptr || !partial->hasFirst())) return false;
  Frame whole;
  Frame::parseHeader(index == 0 ? fragment.message : partial->bytes(), whole);
  return !whole.destination.isBroadcast();
}

// Whether a first fragment begins a frame that has to be cut, and that can be handed on. Reads its header.
bool FragmentReceiver::startsFrame(const Frame &fragment, uint8_t longest, Frame &whole) {
  if (fragment.length != longest || Frame::parseHeader(fragment.message, whole) != FrameError::NONE) return false;
  const uint16_t most =
      static_cast<uint16_t>(whole.destination.isBroadcast() ? MAX_CONTENT_LENGTH : MAX_CONTENT_LENGTH + SEAL_LENGTH);
  const uint8_t count = fragments::count(static_cast<uint16_t>(HEADER_LENGTH + whole.length), longest);
  const Address::Kind to = whole.destination.kind();
  return count > 1 && count <= MAX_FRAGMENTS && whole.length <= most &&
         (to == Address::DEVICE || to == Address::MULTICAST || to == Address::BROADCAST) &&
         whole.origin == fragment.origin;
}

// Whether the frame that a first fragment begins is of use. Where not, its other fragments are ignored too.
template <typename Scope>
bool FragmentReceiver::isWanted(const Frame &fragment, uint8_t id, const Frame &whole, bool wantsAnswer, uint16_t now) {
  const bool broadcast = whole.destination.isBroadcast();
  if (broadcast && ignored_.covers(fragment.origin, id, now)) return false;
  if (acceptor_->isForUs<Scope>(whole) && (broadcast || acceptor_->needsMore(whole, whole.message, wantsAnswer))) {
    ignored_.remove(fragment.origin, id);
    return true;
  }
  PartialFrame *partial = reassembly_.find(fragment.origin, id);
  if (partial != nullptr && partial->hasFirst()) return false;  // it may be forged, and the one that is here not
  if (partial != nullptr) reassembly_.release(*partial);
  ignored_.add(fragment.origin, id, now);
  return false;
}

PartialFrame *FragmentReceiver::placeFor(const Address &origin, uint8_t id, uint8_t longest, bool isFirst,
                                         uint16_t begun) {
  PartialFrame *partial = reassembly_.find(origin, id);
  if (partial != nullptr) return partial;
  bool expired = false;
  partial = reassembly_.begin(origin, id, longest, isFirst, expired);
  if (expired) acceptor_->drop(Counter::RADIO_EXPIRED);
  if (partial != nullptr) partial->begun = begun;
  return partial;
}

// Hands the message on where all its fragments are here. Of some there may be two, of which one is forged.
void FragmentReceiver::finish(PartialFrame &partial, uint16_t now) {
  bool wasWhole = false;
  bool isOther = true;
  for (uint8_t turn = 0; turn < PartialFrame::CHOICES; turn++) {
    Frame whole;
    if (isOther && partial.isWhole()) {
      wasWhole = wasWhole || turn == 0;
      Frame::parseHeader(partial.bytes(), whole);
      if (acceptor_->isGenuine(whole, partial.bytes(), partial.length())) {
        const uint16_t length = partial.length();
        uint8_t *const bytes = reassembly_.release(partial);
        Frame::parseHeader(bytes, whole);
        const uint16_t age = static_cast<uint16_t>(now - partial.begun);
        if (acceptor_->accept(whole, bytes, length, age)) ignored_.add(partial.origin, partial.id, now);
        return;
      }
    }
    isOther = partial.choose(turn);
  }
  if (!wasWhole) return;
  acceptor_->drop(Counter::RADIO_BAD_TAG);
  partial.refuse();
}

void FragmentReceiver::answer(FrameAcceptor &acceptor, const PartialFrame &partial) {
  Frame whole;
  Frame::parseHeader(partial.bytes(), whole);
  if (whole.destination.isDevice()) acceptor.answerFragment(whole, whole.message, partial.undoubted());
}

template bool FragmentReceiver::accept<WholeScope>(const Frame &, uint8_t, uint16_t, bool);
template bool FragmentReceiver::accept<UnicastScope>(const Frame &, uint8_t, uint16_t, bool);

void FragmentReceiver::run() {
  const uint16_t now = static_cast<uint16_t>(clock::millis());
  for (uint8_t left = reassembly_.expire(now, expiryMillis_); left != 0; left--)
    acceptor_->drop(Counter::RADIO_EXPIRED);
  ignored_.expire(now, expiryMillis_);
}

}  // namespace javinolib
