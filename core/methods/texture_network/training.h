#pragma once

#include "core/methods/generator_training.h"
#include "core/methods/texture_network/settings.h"

#include <memory>
#include <optional>

namespace texloom::texture_network {

/// What the exemplar is scaled to, so that no side is longer than the settings allow.
Size trainedSize(const Request& request, const Settings& settings);

/// Trains a generator until its pictures look like the exemplar.
class Training {
public:
    Training(const Request& request, const Settings& settings, JobContext& context);

    void run();

    double loss() const { return m_training.loss(); }
    std::vector<Message> notes() const;
    /// What was learned, with what a model's notes say of it.
    std::shared_ptr<Model> model() const;
    const GeneratorWeights& weights() const { return m_training.weights(); }

    static std::uint64_t bytesFor(const Request& request, const Settings& settings, int threads);
    static double secondsFor(const Request& request, const Settings& settings);

private:
    std::optional<Descriptor> descriptorFor() const;
    GeneratorLoss lossFor() const;
    GeneratorWeights startingWeights() const;
    double iteration(int number);

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    std::optional<Descriptor> m_descriptor;
    GeneratorLoss m_loss;
    GeneratorTraining m_training;
};

} // namespace texloom::texture_network
