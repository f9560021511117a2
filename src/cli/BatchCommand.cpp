#include "BatchCommand.h"
#include "Commands.h"
#include "stromar/app/Batch.h"
#include "stromar/util/Text.h"
#include <chrono>
#include <cmath>
#include <iostream>

namespace stromar {

namespace {
constexpr double kVerticesPerSecond = 3e5; // about, of one thread

std::string timeText(double seconds) {
    if (seconds < 90) return numberText(std::ceil(seconds)) + " s";
    if (seconds < 5400) return numberText(std::ceil(seconds / 60)) + " min";
    return numberText(std::ceil(seconds / 360) / 10) + " h";
}

std::string bytesText(double bytes) {
    if (bytes < 1e9) return numberText(std::ceil(bytes / 1e5) / 10) + " MB";
    return numberText(std::ceil(bytes / 1e8) / 10) + " GB";
}

BatchPlan planOf(const BatchFlags& flags) {
    try {
        return readPlan(flags.plan);
    } catch (const CInputError& e) {
        throw CUsageError(e.what());
    }
}

void list(const BatchPlan& plan, const std::vector<BatchFile>& files, const BatchFlags& flags, std::ostream& out, const CProgress& progress) {
    BatchSize all;
    for (const BatchFile& file : files) {
        const BatchSize size = sizeOf(plan, file, progress);
        out << file.output.string() << "  " << bytesText(size.bytes) << "\n";
        all.bytes += size.bytes;
        all.vertices += size.vertices;
    }
    out << files.size() << " models, up to " << bytesText(all.bytes) << " without pictures, about "
        << timeText(all.vertices / kVerticesPerSecond / std::max(flags.jobs, progress.threads())) << "\n";
}

/// False when models are missing.
bool merge(const BatchPlan& plan, bool quiet) {
    const BatchManifest manifest = mergeManifests(plan);
    if (!quiet) std::cerr << manifest.file.string() << ": " << manifest.models << " models, " << manifest.missing.size() << " missing\n";
    for (const std::string& missing : manifest.missing) std::cerr << missing << ": no part has made it, or it is not as it was made\n";
    return manifest.missing.empty();
}

/// A line for each file, with the time that is left by those that were written.
class CTeller {
public:
    CTeller(std::size_t count, bool quiet) : m_count(count), m_quiet(quiet) {}

    void operator()(const BatchFile& file, BatchOutcome outcome, std::size_t done) {
        if (outcome != BatchOutcome::Skipped) ++m_made;
        if (m_quiet) return;
        constexpr const char* kWords[] = {"", ", unchanged", ", failed"};
        std::cerr << done << "/" << m_count << " " << file.output.string() << kWords[static_cast<std::size_t>(outcome)];
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
        if (done < m_count && m_made > 0) std::cerr << "; " << timeText(seconds / double(m_made) * double(m_count - done)) << " left";
        std::cerr << "\n";
    }

private:
    std::size_t m_count, m_made = 0;
    bool m_quiet;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};
} // namespace

bool runBatchCommand(const BatchFlags& flags, std::ostream& out, const CProgress& progress) {
    const BatchPlan plan = planOf(flags);
    const std::vector<BatchFile> files = [&] {
        try {
            return filesOf(plan);
        } catch (const CError& e) {
            throw CUsageError(flags.plan + ": " + e.what());
        }
    }();
    if (flags.dryRun) {
        list(plan, files, flags, out, progress);
        return true;
    }
    if (flags.merge) return merge(plan, flags.quiet);
    const bool whole = flags.parts == 1;
    const std::string suffix = whole ? "" : "." + std::to_string(flags.part) + "-of-" + std::to_string(flags.parts);
    const BatchOptions options{flags.jobs, flags.force, flags.limits, flags.plan + suffix + ".done", STROMAR_VERSION, flags.part, flags.parts, true};
    CTeller tell(files.size() / static_cast<std::size_t>(flags.parts), flags.quiet);
    const BatchResult result = runBatch(plan, options, [&](const BatchFile& file, BatchOutcome outcome, std::size_t done) { tell(file, outcome, done); }, progress);
    if (!flags.quiet)
        std::cerr << result.written << " written, " << result.skipped << " unchanged, " << result.failures.size() << " failed\n";
    for (const std::string& failure : result.failures) std::cerr << failure << "\n";
    if (whole) static_cast<void>(mergeManifests(plan));
    return result.failures.empty();
}

} // namespace stromar
