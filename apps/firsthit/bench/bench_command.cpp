// bench_command.cpp - `firsthit bench`: how fast, beside the paper's numbers and other ray casters.
#include "bench/bench_command.h"

#include "bench/baseline/baseline.h"
#include "bench/paper/paper.h"
#include "bench/report/machine.h"
#include "bench/report/report.h"
#include "common/interrupt.h"
#include "common/output.h"
#include "common/usage.h"

#include <firsthit/file.h>

#include <fmt/format.h>

namespace firsthit::cli::bench {

int run_bench(const BenchOptions& options)
{
    check(options);
    check_inputs_stay(options);
    // A folder that cannot be made is said before minutes are spent.
    const ReportFolder made(output_folder(options));
    const std::string& folder = made.path();
    Report report;
    const Machine machine = describe_machine();
    report.json["machine"] = machine_json(machine);
    report.json["quick"] = options.quick;
    if (options.quick)
        report.page.paragraph("Made with --quick: few small frames, whose numbers say nothing.");
    if (options.paper) add_paper(options, report);
    if (options.baseline) add_baseline(options, report);
    report.page.heading("What this was measured on");
    report.add(machine_table(machine));
    report.json["page"] = report.page.json();

    const std::string warning = folder.empty() ? "" : write_report(report, folder);
    if (!warning.empty()) print_warnings({warning});
    const std::string json = to_text(report.json);
    if (options.json == "-")
        print(json);
    else {
        if (!options.json.empty()) {
            const HoldInterrupts hold;
            write_file(options.json, json);
        }
        if (!folder.empty() && warning.empty())
            report.text += fmt::format(
                "The page is {}{}index.html\n", folder, folder.ends_with('/') ? "" : "/");
        print(report.text);
    }
    return kExitDone;
}

} // namespace firsthit::cli::bench
