#include "PieceReceiver.h"

#include "../secure/Envelope.h"
#include "../support/Clock.h"
#include "../support/Trace.h"
#include "Pieces.h"

namespace javinolib {

static const uint8_t INDEX_MASK = MAX_FRAGMENTS - 1;
static const uint8_t INDEXES = MAX_FRAGMENTS + pieces::WANTS_ANSWER;

template <typename Scope>
bool PieceReceiver::accept(const Frame &piece, uint8_t longest, uint16_t age, bool isDoubtful) {
  const uint16_t now = static_cast<uint16_t>(clock::millis());
  const uint8_t id = pieces::idOf(piece.destination);
  const uint8_t index = pieces::indexOf(piece.destination);
  const uint8_t at = index & INDEX_MASK;
  const bool wantsAnswer = (index & pieces::WANTS_ANSWER) != 0;
  Frame whole;
  if (index >= INDEXES || piece.length == 0 || (at == 0 && !startsFrame(piece, longest, whole))) {
    return admission_->drop(Counter::RADIO_FRAGMENTS_DROPPED);
  }
  if (at == 0 ? !isWanted<Scope>(piece, id, whole, wantsAnswer, now) : ignored_.covers(piece.origin, id, now))
    return false;
  if (isDoubtful && !isSealed(piece, id, at)) return admission_->drop(Counter::RADIO_DOUBTFUL);
  PartialFrame *partial = placeFor(piece.origin, id, longest, at == 0, static_cast<uint16_t>(now - age));
  if (partial == nullptr || !partial->add(at, piece.message, static_cast<uint8_t>(piece.length), now)) {
    return admission_->drop(Counter::RADIO_FRAGMENTS_DROPPED);
  }
  trace::tell(trace::FRAGMENT);
  finish(*partial, now);
  if (wantsAnswer && partial->hasFirst()) answer(admission_, *partial);
  return true;
}

// Whether a piece is known to be of a sealed frame: the first piece tells.
bool PieceReceiver::isSealed(const Frame &piece, uint8_t id, uint8_t index) {
  const PartialFrame *const partial = index == 0 ? nullptr : reassembly_.find(piece.origin, id);
  if (index != 0 && (partial == nullptr || !partial->hasFirst())) return false;
  Frame whole;
  Frame::parseHeader(index == 0 ? piece.message : partial->bytes(), whole);
  return !whole.destination.isBroadcast();
}

// Whether a first piece begins a frame that has to be cut, and that can be handed on. Reads its header.
bool PieceReceiver::startsFrame(const Frame &piece, uint8_t longest, Frame &whole) {
  if (piece.length != longest || Frame::parseHeader(piece.message, whole) != FrameError::NONE) return false;
  const uint16_t most =
      static_cast<uint16_t>(whole.destination.isBroadcast() ? MAX_CONTENT_LENGTH : MAX_CONTENT_LENGTH + SEAL_LENGTH);
  const uint8_t count = pieces::count(static_cast<uint16_t>(HEADER_LENGTH + whole.length), longest);
  const Address::Class to = whole.destination.classOf();
  return count > 1 && count <= MAX_FRAGMENTS && whole.length <= most &&
         (to == Address::DEVICE || to == Address::MULTICAST || to == Address::BROADCAST) &&
         whole.origin == piece.origin;
}

// Whether the frame that a first piece begins is of use. Where not, its other pieces are ignored too.
template <typename Scope>
bool PieceReceiver::isWanted(const Frame &piece, uint8_t id, const Frame &whole, bool wantsAnswer, uint16_t now) {
  const bool broadcast = whole.destination.isBroadcast();
  if (broadcast && ignored_.covers(piece.origin, id, now)) return false;
  if (admission_->isForUs<Scope>(whole) && (broadcast || admission_->needsMore(whole, whole.message, wantsAnswer))) {
    ignored_.remove(piece.origin, id);
    return true;
  }
  PartialFrame *partial = reassembly_.find(piece.origin, id);
  if (partial != nullptr && partial->hasFirst()) return false;  // it may be forged, and the one that is here not
  if (partial != nullptr) reassembly_.release(*partial);
  ignored_.add(piece.origin, id, now);
  return false;
}

PartialFrame *PieceReceiver::placeFor(const Address &origin, uint8_t id, uint8_t longest, bool isFirst,
                                      uint16_t begun) {
  PartialFrame *partial = reassembly_.find(origin, id);
  if (partial != nullptr) return partial;
  bool expired = false;
  partial = reassembly_.begin(origin, id, longest, isFirst, expired);
  if (expired) admission_->drop(Counter::RADIO_EXPIRED);
  if (partial != nullptr) partial->begun = begun;
  return partial;
}

// Hands the message on where all its pieces are here. Of some there may be two, of which one is forged.
void PieceReceiver::finish(PartialFrame &partial, uint16_t now) {
  bool wasWhole = false;
  bool isOther = true;
  for (uint8_t turn = 0; turn < PartialFrame::CHOICES; turn++) {
    Frame whole;
    if (isOther && partial.isWhole()) {
      wasWhole = wasWhole || turn == 0;
      Frame::parseHeader(partial.bytes(), whole);
      if (admission_->isGenuine(whole, partial.bytes(), partial.length())) {
        const uint16_t length = partial.length();
        uint8_t *const bytes = reassembly_.release(partial);
        Frame::parseHeader(bytes, whole);
        const uint16_t age = static_cast<uint16_t>(now - partial.begun);
        if (admission_->accept(whole, bytes, length, age)) ignored_.add(partial.origin, partial.id, now);
        return;
      }
    }
    isOther = partial.choose(turn);
  }
  if (!wasWhole) return;
  admission_->drop(Counter::RADIO_BAD_TAG);
  partial.refuse();
}

void PieceReceiver::answer(Admission &admission, const PartialFrame &partial) {
  Frame whole;
  Frame::parseHeader(partial.bytes(), whole);
  if (whole.destination.isDevice()) admission.answerPiece(whole, whole.message, partial.undoubted());
}

template bool PieceReceiver::accept<WholeScope>(const Frame &, uint8_t, uint16_t, bool);
template bool PieceReceiver::accept<UnicastScope>(const Frame &, uint8_t, uint16_t, bool);

void PieceReceiver::run() {
  const uint16_t now = static_cast<uint16_t>(clock::millis());
  for (uint8_t left = reassembly_.expire(now); left != 0; left--) admission_->drop(Counter::RADIO_EXPIRED);
  ignored_.expire(now);
}

}  // namespace javinolib
