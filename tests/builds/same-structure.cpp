// Usage: same-structure CLI_A CLI_B FILE.tree …
// Both programs must grow the same stems: same topology, positions and lengths within 1e-5 m.
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace {
using Json = nlohmann::json;

constexpr double kTolerance = 1e-5;

std::vector<Json> stemsOf(const std::string& program, const std::string& file) {
    const std::string command = "'" + program + "' structure '" + file + "' --quiet";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::vector<Json> stems;
    std::string line;
    for (int c = std::fgetc(pipe.get()); c != EOF; c = std::fgetc(pipe.get())) {
        if (c != '\n') {
            line += static_cast<char>(c);
            continue;
        }
        stems.push_back(Json::parse(line));
        line.clear();
    }
    return stems;
}

bool same(const Json& a, const Json& b) {
    if (a.is_number_float() || b.is_number_float()) return std::abs(a.get<double>() - b.get<double>()) <= kTolerance;
    if (!a.is_structured()) return a == b;
    if (a.size() != b.size()) return false;
    return std::equal(a.begin(), a.end(), b.begin(), same);
}

bool sameTree(const std::string& programA, const std::string& programB, const std::string& file) {
    const std::vector<Json> a = stemsOf(programA, file), b = stemsOf(programB, file);
    if (a.empty() || a.size() != b.size()) {
        std::cerr << file << ": " << a.size() << " and " << b.size() << " stems\n";
        return false;
    }
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!same(a[i], b[i])) {
            std::cerr << file << ": stem " << i << " differs:\n" << a[i] << "\n" << b[i] << "\n";
            return false;
        }
    std::cout << file << ": the same " << a.size() << " stems\n";
    return true;
}
} // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::cerr << "usage: same-structure CLI_A CLI_B FILE.tree ...\n";
        return 2;
    }
    bool all = true;
    for (int i = 3; i < argc; ++i) all = sameTree(argv[1], argv[2], argv[i]) && all;
    return all ? 0 : 1;
}
