#pragma once

#include "core/base/message.h"

namespace texloom {

/// "1 channel" or "3 channels", as a value of a sentence.
inline Message channelText(int channels) {
    return channels == 1 ? Message(TR("1 channel")) : message("{} channels", channels);
}

} // namespace texloom
