// session_messages.h - what pages are told about a session, as JSON.
#pragma once

#include "view/session/view_session.h"

#include <cstdint>
#include <string>

namespace firsthit::cli::view {

/// What a page draws its panels from: switches and what they offer for this scene, keys, stages. To be told again when
/// the scene is another.
std::string described(const ViewSession& session);

/// What changes: values of the switches, the corner, messages, the time of the clip, what is under the pointer.
/// viewers  how many pages look
std::string status_of(const ViewSession& session, Clock::time_point now, std::size_t viewers);

/// The stages of frames that were shown after the first `known`, and counts.
std::string bars_of(const ViewSession& session, Clock::time_point now, std::uint64_t known);

/// {"kind": KIND, "text": TEXT}
std::string text_message(const char* kind, const std::string& text);

} // namespace firsthit::cli::view
