// unix_time_test.cpp - times in ISO 8601.
#include "message_of.h"

#include <firsthit/error.h>
#include <firsthit/sun.h>

#include <gtest/gtest.h>

namespace firsthit {
namespace {

TEST(UnixTime, CountsSecondsSince1970)
{
    EXPECT_EQ(unix_time("1970-01-01T00:00Z"), 0);
    EXPECT_EQ(unix_time("1970-01-01T00:00:01.25Z"), 1.25);
    EXPECT_EQ(unix_time("2001-09-09T01:46:40Z"), 1e9);
    EXPECT_EQ(unix_time("2000-02-29T12:00:00Z"), 951825600);
    EXPECT_EQ(unix_time("1969-12-31T23:59Z"), -60);
}

TEST(UnixTime, ZonesAreTakenAway)
{
    for (const char* text : {"2026-06-21T12:00Z", "2026-06-21T14:00+02:00", "2026-06-21T14:00+0200",
             "2026-06-21T14:00:00+02", "2026-06-21T06:30-05:30", "2026-06-22T01:45:00+13:45"})
        EXPECT_EQ(unix_time(text), 1782043200) << text;
}

TEST(UnixTime, WhatIsNoTimeIsRefused)
{
    EXPECT_EQ(message_of<ArgumentError>([] { unix_time("noon"); }),
        "'noon' is no time: accepted is ISO 8601 with the zone, of the years 1800 to 2199, as "
        "2026-06-21T12:00Z or 2026-06-21T14:00:30+02:00");
    for (const char* text :
        {"", "2026", "2026-06-21", "2026-06-21T12:00", "2026-06-21 12:00Z", "2026-13-21T12:00Z",
            "2026-02-29T12:00Z", "2026-06-31T12:00Z", "2026-06-00T12:00Z", "2026-06-21T24:00Z",
            "2026-06-21T12:60Z", "2026-06-21T12:00:60Z", "2026-06-21T12:00:00.Z",
            "2026-06-21T12:00Zx", "2026-06-21T12:00+", "2026-06-21T12:00+2",
            "2026-06-21T12:00+24:00", "2026-06-21T12:00+02:", "1799-06-21T12:00Z",
            "2200-06-21T12:00Z", "-026-06-21T12:00Z", "2026-6-21T12:00Z", "2026-06-21T12:00z"})
        EXPECT_THROW(unix_time(text), ArgumentError) << text;
}

} // namespace
} // namespace firsthit
