// job_thread.h - a thread that runs one job at a time.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace firsthit::gl {

/// Runs jobs in the background, such as calls of a slow driver, while the caller does other work.
class JobThread {
  public:
    JobThread();
    ~JobThread(); // waits for the job
    JobThread(const JobThread&) = delete;
    JobThread& operator=(const JobThread&) = delete;

    /// Starts a job, which must not throw, after waiting for the last one.
    void start(std::function<void()> job);
    /// Waits until no job is running.
    void wait();

  private:
    void run();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::function<void()> job_; // empty: no job is running
    bool ends_ = false;
    std::thread thread_; // last, because it uses the other members
};

} // namespace firsthit::gl
