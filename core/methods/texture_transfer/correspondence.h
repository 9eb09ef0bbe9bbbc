#pragma once

#include "core/job/job_context.h"
#include "core/methods/synthesis.h"
#include "core/methods/texture_transfer/settings.h"

#include <cstdint>
#include <vector>

namespace texloom::texture_transfer {

/// Ids of the ports.
inline constexpr const char *kTarget = "target", *kCorrespondence = "correspondence";

/// What is compared between the target and the exemplars (Efros & Freeman 2001, section 4): the blurred
/// luminance of both, or pictures of the exemplars that were given, with the target itself.
class Correspondence {
public:
    /// @param request checked by checkCorrespondence(); must outlive this.
    Correspondence(const Request& request, const Settings& settings, JobContext& context);

    /// One for each exemplar, of its size.
    const std::vector<ImageView>& exemplars() const { return m_exemplars; }
    /// Of the output's size.
    const ImageView& target() const { return m_target; }

    /// Bytes that it takes while it is made.
    static std::uint64_t bytesFor(const Request& request);

private:
    std::vector<Image> m_made; ///< what the views refer to where nothing was given
    std::vector<ImageView> m_exemplars;
    ImageView m_target;
};

/// Channels of what is compared.
int correspondenceChannels(const Request& request);

/// @throws UsageError where some exemplars have a picture that corresponds to the target and others have
/// none, or where its channels are not the target's.
void checkCorrespondence(const Request& request);

} // namespace texloom::texture_transfer
