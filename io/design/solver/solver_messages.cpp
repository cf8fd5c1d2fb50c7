// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/solver/solver_messages.hpp"

#include "io/design/texts/scene_texts.hpp"
#include "io/formats/work/long_work.hpp"

namespace netloft::design {

std::string text_of(const Json& message) {
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json message_of(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const WrongRequest& e) {
    return {{"wrong", e.what()}};
  } catch (const Refused& e) {
    return {{"refused", e.what()}};
  } catch (const formats::Interrupted& e) {
    return {{"interrupted", e.what()}};
  } catch (const std::exception& e) {  // such as a full disk or a lack of memory
    return {{"failed", e.what()}};
  }
}

void throw_sent(const Json& message) {
  const std::string kind = message.begin().key(), sentence = message.begin().value();
  if (kind == "wrong") throw WrongRequest(sentence);
  if (kind == "refused") throw Refused(sentence);
  if (kind == "interrupted") throw formats::Interrupted{};
  throw std::runtime_error(sentence);
}

}  // namespace netloft::design
