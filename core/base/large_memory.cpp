#include "core/base/large_memory.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>

namespace texloom {

namespace {

constexpr std::align_val_t kAlignment{64};

// What the system gives itself is unknown to the address sanitizer, which would not see writes beyond its
// end.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kFromSystem = false;
#else
constexpr bool kFromSystem = true;
#endif

constexpr std::size_t kSmallPage = 4096;
constexpr std::size_t kLargePage = 2U << 20U;

std::size_t inPages(std::size_t bytes) {
    return (bytes + kSmallPage - 1) / kSmallPage * kSmallPage;
}

/// Whole pages that begin where a large page does; the rest, which fills none, is of small pages, so that no
/// more is taken than was asked for.
void* pagesFor(std::size_t bytes) {
    if (bytes > std::numeric_limits<std::size_t>::max() - 2 * kLargePage)
        throw std::bad_alloc();
    const std::size_t wanted = inPages(bytes), mapped = wanted + kLargePage;
    void* const place = ::mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED)
        throw std::bad_alloc();
    auto* const begin = static_cast<std::byte*>(place);
    const std::size_t before =
        (kLargePage - reinterpret_cast<std::uintptr_t>(begin) % kLargePage) % kLargePage;
    if (before > 0)
        ::munmap(begin, before);
    ::munmap(begin + before + wanted, kLargePage - before);
    ::madvise(begin + before, wanted / kLargePage * kLargePage, MADV_HUGEPAGE); // without, it is only slower
    return begin + before;
}

} // namespace

void* allocateMemory(std::size_t bytes) {
    if (bytes < kLargeMemory)
        return ::operator new(bytes, kAlignment);
    if (kFromSystem)
        return pagesFor(bytes);
    return std::memset(::operator new(bytes, kAlignment), 0, bytes);
}

void freeMemory(void* memory, std::size_t bytes) noexcept {
    if (kFromSystem && bytes >= kLargeMemory)
        ::munmap(memory, inPages(bytes));
    else
        ::operator delete(memory, kAlignment);
}

template <class T>
ZeroedBuffer<T>::ZeroedBuffer(std::size_t count)
    : m_data(static_cast<T*>(allocateMemory(count * sizeof(T)))), m_size(count) {
    if (count * sizeof(T) < kLargeMemory)
        std::fill_n(m_data, count, T{});
}

template <class T>
ZeroedBuffer<T>::ZeroedBuffer(const ZeroedBuffer& other)
    : m_data(static_cast<T*>(allocateMemory(other.m_size * sizeof(T)))), m_size(other.m_size) {
    std::copy_n(other.m_data, m_size, m_data);
}

template class ZeroedBuffer<float>;
template class ZeroedBuffer<unsigned char>;

} // namespace texloom
