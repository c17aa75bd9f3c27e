// Python's lock: given up while a thread computes, and taken again as long as there is a Python.
#pragma once

#include <chrono>

#include <nanobind/nanobind.h>

namespace hodt::python {

/// A thread that has or wants the lock in here, or that computes for one: Python's end waits for
/// it.
class AtWork {
 public:
  AtWork();
  ~AtWork();
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;
};

/// Lets other Python threads run while it lives.
class WithoutLock {
 public:
  WithoutLock() : state_(PyEval_SaveThread()) {}
  ~WithoutLock();
  WithoutLock(const WithoutLock&) = delete;
  WithoutLock& operator=(const WithoutLock&) = delete;

 private:
  PyThreadState* state_;
};

/// Of all threads, only this one takes the lock in here from now on: it ends Python. Python ends
/// others where they ask for the lock, until 3.13 by an exception that aborts the process where it
/// meets C++. So those that are in here stay.
void keep_lock_for_this_thread();
/// The calling thread has the lock. Does not return if it is another's to the end.
void stay_if_lock_is_kept();
/// Without the lock, until no other thread is at work, or for so long.
void wait_for_others(std::chrono::seconds patience);
/// After a fork: a child has no thread but the one that forked.
void forget_others();

}  // namespace hodt::python
