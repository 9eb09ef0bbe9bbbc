#include "core/methods/generator_training.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace texloom {

namespace {

/// What a checkpoint holds before the trainer's own state.
struct Head {
    double loss = 0;
    std::int64_t next = 0; ///< the iteration to go on with
};

} // namespace

void GeneratorTraining::run(const std::function<double(int)>& iteration,
                            const std::function<double(int)>& rate) {
    if (const std::string* earlier = m_context.resumed())
        takeUp(*earlier);
    for (; m_done < m_iterations && !m_stopped; ++m_done) {
        m_good = m_trainer.weights();
        const double loss = iteration(m_done);
        if (!std::isfinite(loss) || !m_trainer.finite()) {
            m_brokeDown = true;
            return;
        }
        m_loss += (loss - m_loss) / std::min(m_done + 1, kRecent);
        m_trainer.step(rate(m_done));
        m_context.curve(TR("Loss"), loss);
        m_context.progress((m_done + 1.0) / m_iterations);
        m_context.checkpoint(std::chrono::seconds(30), [&] { return state(); });
    }
}

void GeneratorTraining::show(Size full, const std::function<Image()>& made) {
    const auto laidOut = [&](Size size, int step) {
        const Image sample = made();
        Image picture(size, sample.channels());
        for (int c = 0; c < sample.channels(); ++c)
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    picture(x, y, c) = sample(x * step % sample.width(), y * step % sample.height(), c);
        return picture;
    };
    try {
        m_context.preview(full, laidOut);
    } catch (const StoppedEarly&) { // what was learned is worth more than this picture
        m_stopped = true;
    }
}

std::vector<Message> GeneratorTraining::notes() const {
    if (m_brokeDown)
        return {message("Training ended after {} of {} iterations, since the next gave values that are not "
                        "numbers; the generator is that of the last good step. A smaller learning rate may "
                        "go further.",
                        m_done, m_iterations)};
    if (m_done < m_iterations)
        return {message("Stopped after {} of {} iterations; the generator knows what it had learned by then.",
                        m_done, m_iterations)};
    return {};
}

std::string GeneratorTraining::state() const {
    const Head head{m_loss, m_done + 1};
    return std::string(reinterpret_cast<const char*>(&head), sizeof head) + m_trainer.state();
}

void GeneratorTraining::takeUp(const std::string& text) {
    Head head;
    if (text.size() < sizeof head)
        fail("The checkpoint is of a generator of another size; start again without it.");
    std::memcpy(&head, text.data(), sizeof head);
    m_loss = head.loss;
    m_done = static_cast<int>(head.next);
    m_trainer.restore(text.substr(sizeof head));
}

Image planeOf(const VolumeSource& solid, const Region& part, JobContext& context) {
    Image image(part.size, solid.channels());
    constexpr int kRows = 128;
    for (int begin = 0; begin < part.size.height; begin += kRows) {
        const int rows = std::min(kRows, part.size.height - begin);
        const Volume slab = solid.sample({part.x, part.y + begin, 0, {part.size.width, rows, 1}}, context);
        for (int c = 0; c < slab.channels(); ++c)
            for (int y = 0; y < rows; ++y)
                std::copy_n(slab.row(y, 0, c), slab.width(), image.plane(c).row(begin + y));
        context.progress(static_cast<double>(begin + rows) / part.size.height);
    }
    return image;
}

} // namespace texloom
