#include "PublishedJavino.h"

#include <string.h>

static Javino *theOne;

Javino::Javino() : perceive_(nullptr), askedAt_(0), isOpen_(false) {
  theOne = this;
  act.count_ = 0;
}

Javino::Function &Javino::Actions::operator[](const char *name) {
  uint8_t i = 0;
  while (i != count_ && strcmp(entries_[i].name, name) != 0) i++;
  if (i == count_) {
    if (count_ != javinolib::config::ACTIONS) count_++;
    i = count_ - 1;  // what is one too many takes the place of the last
    entries_[i] = {name, nullptr};
  }
  return entries_[i].function;
}

Javino::Function Javino::Actions::find(const String &name) const {
  for (uint8_t i = 0; i != count_; i++) {
    if (name == entries_[i].name) return entries_[i].function;
  }
  return nullptr;
}

void Javino::start(unsigned long) {
  isOpen_ = true;
  board_.onPercepts(perceive);
  board_.performBy(perform);
  board_.begin(115200);
}

void Javino::readSerial() { board_.serve(); }

bool Javino::availableMsg() {
  if (!isOpen_) start(0);
  board_.serve();
  if (wanted_.length() != 0) {
    message_ = wanted_;
    wanted_ = String();
    return true;
  }
  if (perceive_ != nullptr || !board_.wantsPercepts() || millis() - askedAt_ < 20) return false;
  askedAt_ = millis();
  message_ = F("getPercepts");
  return true;
}

bool Javino::requestPercepts() const { return message_ == F("getPercepts"); }

void Javino::sendPercepts() {
  reading_ = percepts_;
  clearPercepts();
}

// The sketch's function is called when the agent is to be told: it may forget what it adds.
void Javino::perceive(javinolib::Percepts &percepts) {
  String &all = theOne->reading_;
  if (theOne->perceive_ != nullptr) {
    all = String();
    theOne->perceive_();
    all += theOne->percepts_;
    theOne->clearPercepts();
  }
  // Semicolons within a string part nothing.
  bool isQuoted = false;
  bool isEscaped = false;
  unsigned int begin = 0;
  for (unsigned int i = 0; i <= all.length(); i++) {
    const char next = i == all.length() ? '\0' : all[i];
    if (next == '"' && !isEscaped) isQuoted = !isQuoted;
    isEscaped = next == '\\' && !isEscaped;
    if (next != '\0' && (next != ';' || isQuoted)) continue;
    if (i != begin) percepts.literal(all.substring(begin, i));
    begin = i + 1;
  }
}

// The agent gets an error for what a sketch does not know; one without functions is asked by availableMsg().
javinolib::Status Javino::perform(javinolib::Part<javinolib::Actions>, const uint8_t *action, javinolib::Length length,
                                  javinolib::Reply &) {
  using javinolib::Status;
  if (length == 0) return Status::BAD_ARGUMENT;
  String text;
  for (uint16_t i = 0; i != length; i++) text += static_cast<char>(action[i]);
  if (theOne->act.count_ == 0) {
    if (theOne->wanted_.length() != 0) return Status::ACTION_FAILED;
    theOne->wanted_ = text;
    return Status::OK;
  }
  // The published library knows whole texts only.
  Function function = theOne->act.find(text);
  const int bracket = text.indexOf('(');
  if (function == nullptr && bracket > 0) function = theOne->act.find(text.substring(0, bracket));
  if (function == nullptr) return Status::ACTION_FAILED;
  theOne->message_ = text;
  function();
  return Status::OK;
}
