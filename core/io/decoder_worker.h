#pragma once

#include "core/io/image_decode.h"
#include "core/io/process_channel.h"

#include <string>

namespace texloom {

/// A request as the text of a message.
std::string requestText(const DecodeRequest& request);

/// What a decoder's process does: decodes within limits of time and memory, and answers.
void decodeFor(const std::string& text, const Handle& answer);

} // namespace texloom
