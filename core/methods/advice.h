#pragma once

#include "core/analysis/texture_character.h"
#include "core/base/message.h"
#include "core/methods/method.h"

#include <vector>

namespace texloom {

/// Which methods to try first with a texture.
struct MethodAdvice {
    std::vector<const Method*> methods; ///< those that make more of an exemplar, the fittest first
    Message reason;                     ///< what in the texture speaks for them, in one sentence
};

/// Weighs how well each method suits textures of four kinds (MethodInfo::suits) by how much the texture is of
/// each of them. Of methods that suit alike, those listed first come first.
MethodAdvice adviceFor(const TextureCharacter& character);

/// How much a texture is of each kind; together 1.
struct KindShares {
    double regular = 0, grain = 0, objects = 0, large = 0;
};
KindShares kindsOf(const TextureCharacter& character);

} // namespace texloom
