#pragma once

#include "core/generator/trainer.h"
#include "core/image/image.h"
#include "core/volume/volume_source.h"

#include <functional>
#include <string>
#include <vector>

namespace texloom {

/// The training of a generator as methods run it: a curve of the loss, pictures of what it makes, checkpoints
/// to go on from bit for bit, the end where it is told to stop and keep what it has, and where a step would
/// give values that are no numbers.
class GeneratorTraining {
public:
    GeneratorTraining(GeneratorWeights start, int iterations, JobContext& context)
        : m_iterations(iterations), m_context(context), m_trainer(std::move(start)) {}

    /// What iterations make pictures with and add derivatives to.
    GeneratorTrainer& trainer() { return m_trainer; }
    /// All iterations from the checkpoint, or the first, on. @param iteration adds the derivatives of a loss
    /// and returns that loss. @param rate of each iteration's step.
    void run(const std::function<double(int)>& iteration, const std::function<double(int)>& rate);
    /// To be called by an iteration for what it made: shows it over and over in a picture of `full` size.
    /// @param made called only where it is looked at, or kept.
    void show(Size full, const std::function<Image()>& made);

    /// What was learned, up to the last good step.
    const GeneratorWeights& weights() const { return m_brokeDown ? m_good : m_trainer.weights(); }
    int iterationsDone() const { return m_done; }
    /// Mean over about the last kRecent iterations, each of which saw other slices.
    double loss() const { return m_loss; }
    /// What the user is told of an early end; empty if there was none.
    std::vector<Message> notes() const;

private:
    static constexpr int kRecent = 50;

    std::string state() const;
    void takeUp(const std::string& text);

    int m_iterations;
    JobContext& m_context;
    GeneratorTrainer m_trainer;
    GeneratorWeights m_good; ///< before the step under way
    int m_done = 0;
    bool m_stopped = false; ///< told to stop and keep what there is
    bool m_brokeDown = false;
    double m_loss = 0;
};

/// A part of the plane z = 0 of a solid, with progress by rows.
Image planeOf(const VolumeSource& solid, const Region& part, JobContext& context);

} // namespace texloom
