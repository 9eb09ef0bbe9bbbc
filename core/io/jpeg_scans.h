#pragma once

#include <string_view>

namespace texloom {

/// Whether the scans that a JPEG holds give every coefficient of every component to its last bit. Each scan
/// gives some of them: of a progressive file a band of frequencies down to some bit (ITU-T T.81, G.1.1.1), of
/// others one or more components whole. Only the scans' headers are looked at, not whether their data are all
/// there.
bool hasAllScans(std::string_view jpeg);

} // namespace texloom
