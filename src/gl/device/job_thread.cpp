// job_thread.cpp - a thread that runs one job at a time.
#include "gl/device/job_thread.h"

#include <utility>

namespace firsthit::gl {

JobThread::JobThread() : thread_([this] { run(); }) {}

JobThread::~JobThread()
{
    wait();
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void JobThread::start(std::function<void()> job)
{
    wait();
    {
        const std::lock_guard lock(mutex_);
        job_ = std::move(job);
    }
    changed_.notify_all();
}

void JobThread::wait()
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !job_; });
}

void JobThread::run()
{
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [&] { return job_ || ends_; });
        if (ends_) return;
        lock.unlock();
        job_();
        lock.lock();
        job_ = nullptr;
        changed_.notify_all();
    }
}

} // namespace firsthit::gl
