#include "core/session/results/result_store.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom {

namespace {

/// So many earlier runs, those most like the planned one, say how long it will take.
constexpr std::size_t kWitnesses = 5;

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

std::size_t ResultStore::indexOf(const std::string& key) const {
    const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const ResultEntry& entry) { return entry.key == key; });
    return static_cast<std::size_t>(found - m_entries.begin());
}

const ResultEntry* ResultStore::find(const std::string& key) const {
    const std::size_t index = indexOf(key);
    return index < m_entries.size() ? &m_entries[index] : nullptr;
}

void ResultStore::addEarlier(std::vector<ResultEntry> entries) {
    std::erase_if(entries, [this](const ResultEntry& entry) { return find(entry.key) != nullptr; });
    State onDisk;
    onDisk.saved = true;
    m_states.insert(m_states.begin(), entries.size(), onDisk);
    m_entries.insert(m_entries.begin(), std::make_move_iterator(entries.begin()),
                     std::make_move_iterator(entries.end()));
}

void ResultStore::add(const ResultEntry& entry, std::shared_ptr<const Result> result) {
    m_entries.push_back(entry);
    m_states.push_back({std::move(result), false, 0, ++m_uses});
    dropBeyondMemory();
}

void ResultStore::saved(const std::string& key, std::uint64_t bytesOnDisk) {
    const std::size_t index = indexOf(key);
    if (index == m_entries.size())
        return;
    m_states[index].saved = true;
    m_states[index].bytesOnDisk = bytesOnDisk;
    dropBeyondMemory();
}

void ResultStore::loaded(const std::string& key, std::shared_ptr<const Result> result) {
    const std::size_t index = indexOf(key);
    if (index == m_entries.size())
        return;
    m_states[index].result = std::move(result);
    m_states[index].used = ++m_uses;
    dropBeyondMemory();
}

std::shared_ptr<const Result> ResultStore::inMemory(const std::string& key) {
    const std::size_t index = indexOf(key);
    if (index == m_entries.size())
        return nullptr;
    m_states[index].used = ++m_uses;
    return m_states[index].result;
}

std::shared_ptr<const Result> ResultStore::peek(const std::string& key) const {
    const std::size_t index = indexOf(key);
    return index < m_states.size() ? m_states[index].result : nullptr;
}

void ResultStore::setTitle(const std::string& key, const std::string& title) {
    if (const std::size_t index = indexOf(key); index < m_entries.size())
        m_entries[index].title = title;
}

void ResultStore::setPinned(const std::string& key, bool pinned) {
    if (const std::size_t index = indexOf(key); index < m_entries.size())
        m_entries[index].pinned = pinned;
}

void ResultStore::setStars(const std::string& key, int stars) {
    if (const std::size_t index = indexOf(key); index < m_entries.size())
        m_entries[index].stars = std::clamp(stars, 0, ResultEntry::kMostStars);
}

void ResultStore::setVaried(const std::string& key, const std::vector<Message>& varied) {
    if (const std::size_t index = indexOf(key); index < m_entries.size())
        m_entries[index].varied = varied;
}

std::optional<ResultEntry> ResultStore::take(const std::string& key) {
    const std::size_t index = indexOf(key);
    if (index == m_entries.size())
        return {};
    const auto at = static_cast<std::ptrdiff_t>(index);
    ResultEntry taken = std::move(m_entries[index]);
    m_entries.erase(m_entries.begin() + at);
    m_states.erase(m_states.begin() + at);
    return taken;
}

void ResultStore::putBack(const ResultEntry& entry) {
    const auto place = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const ResultEntry& other) { return other.key > entry.key; });
    State onDisk;
    onDisk.saved = true;
    m_states.insert(m_states.begin() + (place - m_entries.begin()), onDisk);
    m_entries.insert(place, entry);
}

void ResultStore::setMemoryBudget(std::uint64_t bytes) {
    m_memoryBudget = bytes;
    dropBeyondMemory();
}

std::uint64_t ResultStore::memoryUsed() const {
    std::uint64_t used = 0;
    for (std::size_t i = 0; i < m_entries.size(); ++i)
        used += m_states[i].result ? m_entries[i].bytes : 0;
    return used;
}

std::uint64_t ResultStore::diskUsed() const {
    std::uint64_t used = 0;
    for (std::size_t i = 0; i < m_entries.size(); ++i)
        used += onDisk(i);
    return used;
}

std::uint64_t ResultStore::onDisk(std::size_t index) const {
    return m_states[index].bytesOnDisk > 0 ? m_states[index].bytesOnDisk : m_entries[index].bytes;
}

void ResultStore::dropBeyondMemory() {
    std::uint64_t used = memoryUsed();
    while (used > m_memoryBudget) {
        State* oldest = nullptr;
        std::uint64_t bytes = 0;
        for (std::size_t i = 0; i < m_states.size(); ++i) {
            State& state = m_states[i];
            if (state.result && state.saved && (oldest == nullptr || state.used < oldest->used)) {
                oldest = &state;
                bytes = m_entries[i].bytes;
            }
        }
        if (oldest == nullptr)
            return;
        oldest->result.reset();
        used -= bytes;
    }
}

std::vector<std::string> ResultStore::beyondDisk() const {
    std::vector<std::string> keys;
    std::uint64_t used = diskUsed();
    for (std::size_t i = 0; i + 1 < m_entries.size() && used > m_diskBudget; ++i)
        if (!m_entries[i].pinned) {
            keys.push_back(m_entries[i].key);
            used -= onDisk(i);
        }
    return keys;
}

std::optional<double> expectedSeconds(const RunPlan& plan, const std::vector<ResultEntry>& earlier) {
    /// How unlike the planned run an earlier one was in size of work, and how long it took for its size.
    using Witness = std::pair<double, double>;
    std::vector<Witness> witnesses;
    const std::string ids = plan.methodIds(" + ");
    for (const ResultEntry& entry : earlier)
        if (entry.threads == plan.threads && entry.estimateSeconds > 0 && !entry.stoppedAt &&
            entry.methodIds() == ids)
            witnesses.emplace_back(std::abs(std::log(plan.estimate.seconds / entry.estimateSeconds)),
                                   entry.seconds / entry.estimateSeconds);
    if (witnesses.empty())
        return {};
    std::sort(witnesses.begin(), witnesses.end());
    witnesses.resize(std::min(witnesses.size(), kWitnesses));
    std::vector<double> paces;
    for (const auto& [unlikeness, pace] : witnesses)
        paces.push_back(pace);
    return plan.estimate.seconds * median(std::move(paces));
}

} // namespace texloom
