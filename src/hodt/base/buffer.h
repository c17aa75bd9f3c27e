// A flat array that is not initialised.
//
// At a million points a third of a triangulation's time can go to the kernel handing out zeroed
// 4 KiB pages. A Buffer asks for huge pages where the system has them, and leaves its elements
// unwritten, so that memory is touched once, by whoever computes the value.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

namespace hodt {

/// Raw storage of `bytes` bytes, on huge pages where that pays. Throws std::bad_alloc.
void* allocate_pages(std::size_t bytes);
void free_pages(void* memory) noexcept;

template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  Buffer() = default;
  explicit Buffer(std::size_t size)
      : data_(size ? static_cast<T*>(allocate_pages(size * sizeof(T))) : nullptr), size_(size) {}
  Buffer(std::size_t size, const T& value) : Buffer(size) { fill(value); }
  Buffer(const Buffer& other) : Buffer(other.size_) {
    if (size_) std::memcpy(static_cast<void*>(data_), other.data_, size_ * sizeof(T));
  }
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer other) noexcept {
    swap(other);
    return *this;
  }
  ~Buffer() { free_pages(data_); }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  operator std::span<const T>() const { return {data_, size_}; }
  operator std::span<T>() { return {data_, size_}; }

  void fill(const T& value) {
    for (T& element : *this) element = value;
  }
  /// Forgets the elements from `size` on; the memory stays.
  void shrink(std::size_t size) { size_ = size; }
  void swap(Buffer& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
  }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace hodt
