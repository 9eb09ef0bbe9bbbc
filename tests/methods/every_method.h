#pragma once

#include "core/methods/method.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace texloom::test {

/// The ids of all registered methods, to run a test over each of them.
inline std::vector<std::string> everyMethod() {
    std::vector<std::string> ids;
    for (const Method& method : methods())
        ids.push_back(method.id());
    return ids;
}

/// An id as part of a test's name, which holds no hyphens.
inline std::string testName(const testing::TestParamInfo<std::string>& tested) {
    std::string name = tested.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

/// A made-up picture that tiles, as inputs of outputs that wrap must.
inline std::shared_ptr<const Image> mirroredBlobs(Size size, int channels) {
    const Image quarter = blobs({(size.width + 1) / 2, (size.height + 1) / 2}, channels, 3);
    Image whole(size, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                whole(x, y, c) =
                    quarter(std::min(x, size.width - 1 - x), std::min(y, size.height - 1 - y), c);
    return std::make_shared<const Image>(std::move(whole));
}

/// Something made up for every port that the method cannot do without.
inline void fillPorts(const MethodInfo& info, Request& request) {
    for (const Port& port : info.takes) {
        if (port.least == 0 || port.id == kExemplarPort)
            continue;
        for (Exemplar& exemplar : request.exemplars)
            if (port.extent == Extent::Exemplar && exemplar.inputs.at(port.id).empty())
                exemplar.inputs.set(port.id, mirroredBlobs(exemplar.image->size(), request.channels()));
        if (port.extent != Extent::Exemplar && request.inputs.at(port.id).empty())
            request.inputs.set(port.id, mirroredBlobs(request.size, request.channels()));
    }
}

} // namespace texloom::test
