#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

namespace texloom {

/// From this many bytes on memory comes from the system itself, and is zero: in pages of 2 MiB where the
/// system has them, each of which comes when it is first touched. A picture of 200 MB then costs 100 page
/// faults in place of 50,000, none of them while it is allocated.
inline constexpr std::size_t kLargeMemory = 4U << 20U;

/// Memory for `bytes`, aligned to 64; zero if they are at least kLargeMemory, else of any value.
/// @throws std::bad_alloc
void* allocateMemory(std::size_t bytes);
/// @param bytes what allocateMemory() was asked for
void freeMemory(void* memory, std::size_t bytes) noexcept;

/// Gives the standard containers such memory.
template <class T> struct LargeAllocator {
    using value_type = T;

    LargeAllocator() = default;
    template <class Other> LargeAllocator(const LargeAllocator<Other>&) {}

    T* allocate(std::size_t count) { return static_cast<T*>(allocateMemory(count * sizeof(T))); }
    void deallocate(T* data, std::size_t count) noexcept { freeMemory(data, count * sizeof(T)); }
    friend bool operator==(LargeAllocator, LargeAllocator) { return true; }
};

/// `count` elements, all zero, aligned to 64 bytes; it never grows.
template <class T> class ZeroedBuffer {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    ZeroedBuffer() = default;
    /// @throws std::bad_alloc
    explicit ZeroedBuffer(std::size_t count);
    ZeroedBuffer(const ZeroedBuffer& other);
    ZeroedBuffer(ZeroedBuffer&& other) noexcept
        : m_data(std::exchange(other.m_data, nullptr)), m_size(std::exchange(other.m_size, 0)) {}
    ZeroedBuffer& operator=(ZeroedBuffer other) noexcept {
        std::swap(m_data, other.m_data);
        std::swap(m_size, other.m_size);
        return *this;
    }
    ~ZeroedBuffer() { freeMemory(m_data, m_size * sizeof(T)); }

    std::size_t size() const { return m_size; }
    T* data() { return m_data; }
    const T* data() const { return m_data; }
    T* begin() { return m_data; }
    T* end() { return m_data + m_size; }
    const T* begin() const { return m_data; }
    const T* end() const { return m_data + m_size; }
    T& operator[](std::size_t index) { return m_data[index]; }
    const T& operator[](std::size_t index) const { return m_data[index]; }

private:
    T* m_data = nullptr;
    std::size_t m_size = 0;
};

extern template class ZeroedBuffer<float>;
extern template class ZeroedBuffer<unsigned char>;

} // namespace texloom
