#pragma once

#include "core/base/at.h"
#include "core/methods/solid_request.h"

#include <vector>

namespace texloom::solid_optimise {

/// One channel of a solid that repeats, whose rows begin with `before` of their last voxels and end with
/// `after` of their first ones, so that neighbourhoods are read in whole rows.
struct Padded {
    Padded(int length, int before, int after)
        : side(length), lead(before), row(length + before + after),
          data(at(row) * at(length) * at(length), 0.0F) {}

    /// Voxel 0 of a row.
    float* begin(int y, int z) { return data.data() + offset(y, z); }
    const float* from(int x, int y, int z) const { return data.data() + offset(y, z) + x; }
    /// Fills what surrounds a row.
    void wrap(int y, int z) {
        float* voxels = begin(y, z);
        for (int x = -lead; x < 0; ++x)
            voxels[x] = voxels[(x + side * lead) % side];
        for (int x = side; x < row - lead; ++x)
            voxels[x] = voxels[x % side];
    }
    /// Appends where the pixels of the square neighbourhoods in slices lie that begin with the voxels of row
    /// (y, z), or for sign −1 end there.
    void taps(Axis axis, int square, int sign, int y, int z, std::vector<const float*>& found) const {
        const auto wrapped = [this](int place) { return ((place % side) + side) % side; };
        for (int j = 0; j < square; ++j)
            for (int i = 0; i < square; ++i) {
                const SliceVoxel v = sliceVoxel(axis, sign * i, sign * j, 0);
                found.push_back(from(v.x, wrapped(y + v.y), wrapped(z + v.z)));
            }
    }

    int side, lead, row;
    std::vector<float> data;

private:
    std::size_t offset(int y, int z) const { return (at(z) * at(side) + at(y)) * at(row) + at(lead); }
};

} // namespace texloom::solid_optimise
