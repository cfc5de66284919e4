// interrupt.cpp - lets a file be finished before the program is stopped.
#include "common/interrupt.h"

namespace firsthit::cli {

namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t g_pending = 0;

void remember(int signal)
{
    g_pending = signal;
}

} // namespace

HoldInterrupts::HoldInterrupts()
{
    g_pending = 0;
    struct sigaction hold {};
    hold.sa_handler = remember;
    hold.sa_flags = SA_RESTART;
    for (std::size_t k = 0; k < kSignals.size(); ++k) sigaction(kSignals[k], &hold, &before_[k]);
}

HoldInterrupts::~HoldInterrupts()
{
    for (std::size_t k = 0; k < kSignals.size(); ++k) sigaction(kSignals[k], &before_[k], nullptr);
    if (g_pending) raise(g_pending);
}

void survive_file_size_limit()
{
    std::signal(SIGXFSZ, SIG_IGN);
}

} // namespace firsthit::cli
