// job_thread.h - a thread that waits for one job at a time.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace firsthit::gl {

/// For what the driver does slowly while the caller has other work.
class JobThread {
  public:
    JobThread();
    ~JobThread(); // waits for the job
    JobThread(const JobThread&) = delete;
    JobThread& operator=(const JobThread&) = delete;

    /// Starts a job, which must not throw, after waiting for the last one.
    void start(std::function<void()> job);
    /// Until no job is running.
    void wait();

  private:
    void run();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::function<void()> job_; // empty: none is running
    bool ends_ = false;
    std::thread thread_; // last, so that it finds all else made
};

} // namespace firsthit::gl
