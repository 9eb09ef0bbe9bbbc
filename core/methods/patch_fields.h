#pragma once

#include "core/base/param.h"
#include "core/base/text.h"

namespace texloom {

/// Parameters that methods of patches have in common, declared once: name, title, range and unit, and help
/// where it is the same for all. A method adds what is its own.

/// Side of the patches. @param share of the exemplar's shorter side that is the default.
template <class Settings> Param patchField(int Settings::*member, double share) {
    return field(member, "patch", TR("Patch size")).range(4, 256).unit("px").scaled(share).symbol("n");
}

/// Share of a patch that overlaps its neighbours (see overlapFor()).
template <class Settings> Param overlapField(double Settings::*member) {
    return field(member, "overlap", TR("Overlap")).range(0.02, 0.5).symbol("o");
}

/// How many patches a new one is made of.
template <class Settings> Param neighboursField(int Settings::*member) {
    return field(member, "neighbours", TR("Neighbours")).range(1, 1000).symbol("m");
}

/// A patch up to 1 + this times as far as the nearest may be drawn.
template <class Settings> Param toleranceField(double Settings::*member) {
    return field(member, "tolerance", TR("Tolerance")).range(0, 10).symbol("ε");
}

/// The same for methods that quilt: w_o and ε of Raad & Galerne (IPOL 2017).
template <class Settings> Param quiltOverlapField(double Settings::*member) {
    return overlapField(member).symbol("w_o").help(TR(
        "Share of the patch that overlaps its neighbours: larger joins better, but repeats itself sooner."));
}

template <class Settings> Param quiltToleranceField(double Settings::*member) {
    return toleranceField(member).help(
        TR("How much worse than the best a patch may fit and still be drawn: larger varies more, smaller "
           "copies longer stretches."));
}

/// How far contrast is balanced where outputs grow from the nearest patches: see ContrastBalance::share.
template <class Settings> Param contrastField(double Settings::*member) {
    return field(member, "contrast", TR("Contrast"))
        .range(0, 1)
        .group(TR("Advanced"))
        .help(TR("How far flat patches are kept from winning where nothing fits well: 1 holds the exemplar's "
                 "contrast; 0 compares as published, and outputs may fade."));
}

/// Whether patches drawn from a Gaussian are kept within what its patches show: see boundPatch().
template <class Settings> Param boundedField(bool Settings::*member) {
    return field(member, "bounded", TR("Bounded"))
        .group(TR("Advanced"))
        .help(TR("Keeps each pixel of a new patch within the lightness and colour that the patches like it "
                 "have there: no sparks and no false colours. Off: the Gaussian as published."));
}

/// Scales of a pyramid.
template <class Settings> Param scalesField(int Settings::*member) {
    return field(member, "scales", TR("Scales"))
        .range(1, 8)
        .symbol("S")
        .help(TR("Most scales, each half the size of the one before: more keep larger structures."));
}

/// λ_occ of the spatial uniformity (Gutierrez, thesis 2020, section 3.2.3). @param most beyond which patches
/// no longer fit one another.
template <class Settings> Param uniformityField(double Settings::*member, double most) {
    return field(member, "uniformity", TR("Uniformity"))
        .range(0, most)
        .symbol("λ_occ")
        .help(TR(
            "How much a patch that is used too often is avoided: larger shows all of the exemplar, 0 takes "
            "whatever fits best."));
}

/// What becomes of the pixels that overlapping patches were joined to: they are kept, or each is replaced by
/// the nearest to it of those that the patches propose.
enum class PatchFinish { Blend, Copy };

template <class Settings> Param finishField(PatchFinish Settings::*member) {
    return field(member, "finish", TR("Finish"))
        .choices({{"blend", TR("Blend")}, {"copy", TR("Copy")}})
        .group(TR("Advanced"))
        .help(TR(
            "Keeps the joined patches, or copies for each pixel the exemplar's nearest to it: sharper, with "
            "an exact map."));
}

} // namespace texloom
