#include "core/methods/portilla_simoncelli/statistics.h"

#include "core/base/text.h"

#include <cmath>

namespace texloom::portilla_simoncelli {

namespace {

/// One statistic or one matrix of them, and what a deviation of it is relative to.
struct Entry {
    Group group;
    double* values;
    Eigen::Index count;
    double scale;
    bool reported;
};

class Entries {
public:
    explicit Entries(Statistics& statistics) {
        for (Moments& moments : statistics.channels)
            addMoments(moments);
        for (Moments& moments : statistics.components)
            addMoments(moments);
        for (ImageStatistics& image : statistics.whole)
            addMatrix(Group::Autocorrelation, image.autocorrelation);
        for (double& variance : statistics.highVariances)
            add(Group::Autocorrelation, variance, 1, false);
        for (auto& scale : statistics.images)
            for (ImageStatistics& image : scale)
                addImage(image);
        addMatrix(Group::BandOrientations, statistics.low, false);
        for (ScaleStatistics& scale : statistics.scales)
            addScale(scale);
    }

    const std::vector<Entry>& all() const { return m_entries; }

private:
    void add(Group group, double& value, double scale, bool reported = true) {
        m_entries.push_back({group, &value, 1, scale, reported});
    }

    void addMatrix(Group group, Eigen::MatrixXd& matrix, bool reported = true) {
        m_entries.push_back({group, matrix.data(), matrix.size(), matrix.norm(), reported});
    }

    void addCross(Group group, Eigen::MatrixXd& matrix, const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
        m_entries.push_back({group, matrix.data(), matrix.size(), std::sqrt(a.norm() * b.norm()), true});
    }

    void addShape(double& skewness, double& kurtosis) {
        add(Group::Marginals, skewness, 1 + std::abs(skewness));
        add(Group::Marginals, kurtosis, kurtosis);
    }

    void addMoments(Moments& moments) {
        const double deviation = std::sqrt(moments.variance);
        add(Group::Marginals, moments.mean, deviation);
        add(Group::Marginals, moments.variance, moments.variance);
        addShape(moments.skewness, moments.kurtosis);
        add(Group::Marginals, moments.smallest, moments.largest - moments.smallest, false);
        add(Group::Marginals, moments.largest, moments.largest - moments.smallest, false);
    }

    /// For very faint low-pass images, only the variance is imposed, and they do not count.
    void addImage(ImageStatistics& image) {
        const bool counts = image.variance() > kLeastVariance;
        addMatrix(Group::Autocorrelation, image.autocorrelation, counts);
        const std::size_t first = m_entries.size();
        addShape(image.skewness, image.kurtosis);
        for (std::size_t i = first; i < m_entries.size(); ++i)
            m_entries[i].reported = counts;
    }

    void addScale(ScaleStatistics& scale) {
        for (std::size_t i = 0; i < scale.magnitudeMeans.size(); ++i) {
            add(Group::MagnitudeAutocorrelation, scale.magnitudeMeans[i], scale.magnitudeMeans[i]);
            addMatrix(Group::MagnitudeAutocorrelation, scale.magnitudeAutocorrelations[i]);
        }
        addCross(Group::MagnitudeScales, scale.magnitudesNext, scale.magnitudes, scale.nextMagnitudes);
        addCross(Group::Phases, scale.realsNext, scale.reals, scale.nextReals);
        addMatrix(Group::MagnitudeOrientations, scale.magnitudes);
        addMatrix(Group::BandOrientations, scale.reals);
        addMatrix(Group::MagnitudeScales, scale.nextMagnitudes, false);
        addMatrix(Group::Phases, scale.nextReals, false);
    }

    std::vector<Entry> m_entries;
};

} // namespace

Message titleOf(Group group) {
    switch (group) {
    case Group::Marginals:
        return TR("Marginals");
    case Group::Autocorrelation:
        return TR("Autocorrelation");
    case Group::MagnitudeAutocorrelation:
        return TR("Magnitudes: autocorrelation");
    case Group::MagnitudeOrientations:
        return TR("Magnitudes: orientations");
    case Group::MagnitudeScales:
        return TR("Magnitudes: scales");
    case Group::BandOrientations:
        return TR("Bands: orientations");
    case Group::Phases:
        return TR("Bands: phases across scales");
    }
    return {};
}

void Statistics::mix(const Statistics& other, double share) {
    Statistics copy = other;
    const Entries mine(*this), theirs(copy);
    for (std::size_t i = 0; i < mine.all().size(); ++i) {
        const Entry &to = mine.all()[i], &from = theirs.all()[i];
        for (Eigen::Index j = 0; j < to.count; ++j)
            to.values[j] += share * (from.values[j] - to.values[j]);
    }
}

Deviations deviations(const Statistics& measured, const Statistics& wanted) {
    Statistics copies[] = {measured, wanted};
    const Entries ours(copies[0]), theirs(copies[1]);
    Deviations squares{};
    std::array<int, kGroups> counts{};
    for (std::size_t i = 0; i < ours.all().size(); ++i) {
        const Entry &mine = ours.all()[i], &aim = theirs.all()[i];
        if (!aim.reported || aim.count == 0 || !(aim.scale > 0))
            continue;
        double square = 0;
        for (Eigen::Index j = 0; j < aim.count; ++j)
            square += std::pow((mine.values[j] - aim.values[j]) / aim.scale, 2);
        squares[static_cast<std::size_t>(aim.group)] += square;
        ++counts[static_cast<std::size_t>(aim.group)];
    }
    for (std::size_t group = 0; group < kGroups; ++group)
        squares[group] = counts[group] > 0 ? std::sqrt(squares[group] / counts[group]) : 0;
    return squares;
}

} // namespace texloom::portilla_simoncelli
