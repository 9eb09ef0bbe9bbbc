#include "core/methods/advice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom {

namespace {

/// 0 up to `low`, 1 from `high` on, and smooth between.
double rising(double value, double low, double high) {
    const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double fitness(const Suits& suits, const KindShares& kinds) {
    return kinds.regular * suits.regular + kinds.grain * suits.grain + kinds.objects * suits.objects +
           kinds.large * suits.large;
}

Message reasonFor(const TextureCharacter& character, const KindShares& kinds) {
    const double most = std::max({kinds.regular, kinds.grain, kinds.objects, kinds.large});
    if (most == kinds.regular && character.rowsOnly)
        return message("It has rows {:.0f} px apart, so methods that keep rows come first.",
                       character.period);
    if (most == kinds.regular)
        return message("It repeats itself every {:.0f} px, so methods that follow a lattice come first.",
                       character.period);
    if (most == kinds.grain)
        return message(
            "It is grain, alike over no more than {:.0f} px, so methods that keep statistics come first.",
            character.longest);
    if (most == kinds.large)
        return message(
            "Its shapes reach over {:.0f} px of {} × {} px, so methods that keep large pieces come "
            "first.",
            character.longest, character.size.width, character.size.height);
    return message(
        "It is alike over about {:.0f} px and does not repeat, so methods that join copied pieces come "
        "first.",
        character.longest);
}

} // namespace

KindShares kindsOf(const TextureCharacter& character) {
    constexpr double kRowsCount = 0.6; // rows repeat in one direction only
    KindShares kinds;
    // A texture that repeats itself only twice or thrice shows little of what it is like.
    const double repeats = 1 - rising(character.period / character.size.shorterSide(), 0.3, 0.45);
    kinds.regular = rising(character.regularity, 0.3, 0.8) * (character.rowsOnly ? kRowsCount : 1) * repeats;
    const double rest = 1 - kinds.regular;
    const double grain = character.grain * (1 - rising(character.reach(), 0.03, 0.1));
    const double large = rising(character.reach(), 0.06, 0.2);
    kinds.grain = rest * grain;
    kinds.large = rest * (1 - grain) * large;
    kinds.objects = rest * (1 - grain) * (1 - large);
    return kinds;
}

MethodAdvice adviceFor(const TextureCharacter& character) {
    const KindShares kinds = kindsOf(character);
    std::vector<std::pair<double, const Method*>> rated;
    for (const Method* method : methodsByCategory())
        if (method->info().suits.any())
            rated.emplace_back(fitness(method->info().suits, kinds), method);
    std::stable_sort(rated.begin(), rated.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    MethodAdvice advice;
    for (const auto& [fit, method] : rated)
        advice.methods.push_back(method);
    advice.reason = reasonFor(character, kinds);
    return advice;
}

} // namespace texloom
