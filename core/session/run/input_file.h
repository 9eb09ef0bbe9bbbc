#pragma once

#include "core/io/recipe.h"
#include "core/methods/port.h"
#include "core/session/run/exemplar_file.h"

#include <map>
#include <string>
#include <vector>

namespace texloom {

/// What goes into one of a method's ports, as it was loaded from a file.
struct InputFile {
    ExemplarFile file; ///< of pictures whole; of everything else path and hash
    Asset asset;

    InputFile() = default;
    // A picture is an input as it is.
    InputFile(ExemplarFile picture)
        : file(std::move(picture)), asset(file.image) {} // NOLINT(google-explicit-constructor)
    const Image* image() const { return file.image.get(); }
};

/// Files by the id of the port that they go into, in the order in which they were given.
using InputFiles = std::map<std::string, std::vector<InputFile>, std::less<>>;

/// Loads what goes into a port. @param exemplars sizes of the run's exemplars, which position maps point
/// into. @throws Error, UsageError where the file is not of the port's kind.
InputFile loadInput(const Port& port, const RecipeFile& file, const std::vector<Size>& exemplars);

/// The first picture of a port; null if it has none.
const ExemplarFile* pictureOf(const InputFiles& inputs, std::string_view port);

} // namespace texloom
