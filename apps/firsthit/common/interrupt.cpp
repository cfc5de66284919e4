// interrupt.cpp - lets a file be finished before the program is stopped.
#include "common/interrupt.h"

#include <cstdlib>

namespace firsthit::cli {

namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t g_pending = 0;

int g_depth = 0; // how many hold them

void remember(int signal)
{
    g_pending = signal;
}

} // namespace

HoldInterrupts::HoldInterrupts()
{
    if (g_depth++ > 0) return;
    g_pending = 0;
    struct sigaction hold {};
    hold.sa_handler = remember;
    hold.sa_flags = SA_RESTART;
    for (std::size_t k = 0; k < kSignals.size(); ++k) {
        sigaction(kSignals[k], &hold, &before_[k]);
        // What is ignored, as in a shell's background or under nohup, stays so.
        if (before_[k].sa_handler == SIG_IGN) sigaction(kSignals[k], &before_[k], nullptr);
    }
}

HoldInterrupts::~HoldInterrupts()
{
    if (--g_depth > 0) return;
    for (std::size_t k = 0; k < kSignals.size(); ++k) sigaction(kSignals[k], &before_[k], nullptr);
    if (g_pending) raise(g_pending);
}

bool HoldInterrupts::is_pending()
{
    return g_pending != 0;
}

void survive_failing_writes()
{
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

void end_by_closed_pipe()
{
    std::signal(SIGPIPE, SIG_DFL);
    raise(SIGPIPE);
    std::_Exit(128 + SIGPIPE); // the signal is blocked
}

} // namespace firsthit::cli
