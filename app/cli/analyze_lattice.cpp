#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/layer_choice.h"
#include "core/analysis/lattice_detector.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/image_file.h"
#include "core/session/run/exemplar_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>

namespace texloom::cli {

namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) {
    return std::round(1000 * value) / 1000;
}

Json toJson(const LatticeCandidate& candidate, int limit) {
    const Lattice& lattice = candidate.lattice;
    const Size rectangle = wrappingRectangle(lattice, limit);
    Json json = {{"v1", {rounded(lattice.v1.x), rounded(lattice.v1.y)}},
                 {"v2", {rounded(lattice.v2.x), rounded(lattice.v2.y)}},
                 {"goodness", rounded(candidate.goodness)},
                 {"correlation", rounded(candidate.correlation)},
                 {"multiples", candidate.multiples}};
    if (!rectangle.empty())
        json["wrappingRectangle"] = {rectangle.width, rectangle.height};
    return json;
}

std::string toLine(const LatticeCandidate& candidate) {
    const Lattice& lattice = candidate.lattice;
    return fmt::format("({:.2f}, {:.2f}) and ({:.2f}, {:.2f}) px, goodness {:.3f}, mean correlation {:.2f}",
                       lattice.v1.x, lattice.v1.y, lattice.v2.x, lattice.v2.y, candidate.goodness,
                       candidate.correlation);
}

void printText(const ExemplarFile& exemplar, const LatticeAnalysis& analysis, int limit) {
    if (analysis.candidates.empty()) {
        fmt::print("Nothing in {} repeats itself.\n", exemplar.name());
        return;
    }
    const LatticeCandidate& best = analysis.candidates.front();
    fmt::print("{}\n  confidence {:.0f} %: {}\n", toLine(best), 100 * analysis.confidence,
               !analysis.found() ? "too little to rely on; methods treat the texture as irregular"
               : best.lattice.keepsOrder(exemplar.image->size())
                   ? "rows that run through it but do not repeat"
               : best.lattice.rowsOnly() ? "rows, along which it does not repeat"
                                         : "a lattice");
    if (analysis.foundInEdges())
        fmt::print("  seen in edges, not in colours\n");
    if (best.lattice.keepsOrder(exemplar.image->size()))
        fmt::print("  rows in their order, again after {:.0f} px\n", best.lattice.area());
    else if (best.lattice.rowsOnly())
        fmt::print("  rows {:.2f} px apart\n", best.lattice.area());
    else if (const Size rectangle = wrappingRectangle(best.lattice, limit); !rectangle.empty())
        fmt::print("  tiles as a rectangle of {} × {} px\n", rectangle.width, rectangle.height);
    for (std::size_t i = 1; i < analysis.candidates.size(); ++i)
        fmt::print("or {}\n", toLine(analysis.candidates[i]));
}

} // namespace

void printLattice(const LatticeOptions& options) {
    LayerChoice layers(options.layers);
    const ExemplarFile exemplar =
        loadExemplar(options.exemplar, options.exemplarSpace, layers.of(LayerChoice::kPictures));
    layers.checkUsed();
    if (!options.picture.empty()) {
        checkWritable(options.picture, 1, depthsFor(options.picture).front());
        checkOnlyOutput({options.exemplar}, options.picture, options.overwrite);
    }
    checkEnoughMemory(exemplar.name(), exemplar.image->size(),
                      latticeBytesFor(exemplar.image->size(), exemplar.image->channels()));
    const auto start = std::chrono::steady_clock::now();
    const LatticeAnalysis analysis = analyzeLattice(*exemplar.image, checkInterrupt, options.criteria);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!options.picture.empty()) {
        WriteOptions write;
        write.depth = depthsFor(options.picture).front();
        write.space = "raw";
        writeImage(options.picture, analysis.rating().picture(), write);
    }
    const int limit = 4 * exemplar.image->size().longerSide();
    if (!options.json) {
        printText(exemplar, analysis, limit);
        return;
    }
    Json json = {{"exemplar", exemplar.name()},
                 {"size", {exemplar.image->width(), exemplar.image->height()}},
                 {"found", analysis.found()},
                 {"inEdges", analysis.foundInEdges()},
                 {"confidence", rounded(analysis.confidence)},
                 {"seconds", seconds},
                 {"candidates", Json::array()}};
    for (const LatticeCandidate& candidate : analysis.candidates)
        json["candidates"].push_back(toJson(candidate, limit));
    fmt::print("{}\n", json.dump(2));
}

} // namespace texloom::cli
