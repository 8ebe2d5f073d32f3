// Reads cases of Graze as CSV, lets your intersect answer them, and writes a file of results.
//
//     g++ -std=c++17 -O2 graze_results.cpp -o graze_results
//     ./graze_results cases.csv results.csv
//
// `npm run grade -- --cases cases.csv` writes the cases, as does the page Check. Fill in intersect.
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// A shape's numbers by their symbols: of a sphere Cx, Cy, Cz and r; an axis is in `words`.
struct Shape {
    std::string kind;
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> words;
};
struct Vec {
    double x, y, z;
};

// All t at which the line E + t d meets the shape: ascending, a tangent once. Throw for what is no
// shape or no ray.
std::vector<double> intersect(const Shape& shape, const Vec& E, const Vec& d) {
    (void)shape, (void)E, (void)d;
    return {};
}

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> found;
    std::string cell;
    for (char c : line) {
        if (c == ',') {
            found.push_back(cell);
            cell.clear();
        } else if (c != '\r') {
            cell += c;
        }
    }
    found.push_back(cell);
    return found;
}

int main(int count, char** words) {
    if (count != 3) {
        std::cerr << "graze_results cases.csv results.csv\n";
        return 2;
    }
    std::ifstream in(words[1]);
    std::ofstream out(words[2]);
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> head = cells(line);
    out << "id,t1,t2\n" << std::setprecision(17);
    while (std::getline(in, line)) {
        const std::vector<std::string> row = cells(line);
        Shape shape;
        std::map<std::string, double> ray;
        for (std::size_t i = 1; i < row.size() && i < head.size(); i++) {
            if (head[i] == "kind") {
                shape.kind = row[i];
            } else if (!row[i].empty()) {
                char* end = nullptr;
                const double x = std::strtod(row[i].c_str(), &end);
                if (end == row[i].c_str()) shape.words[head[i]] = row[i];
                else if (i < 8) ray[head[i]] = x;
                else shape.numbers[head[i]] = x;
            }
        }
        out << row[0];
        try {
            const Vec E{ray["Ex"], ray["Ey"], ray["Ez"]}, d{ray["dx"], ray["dy"], ray["dz"]};
            for (double t : intersect(shape, E, d)) out << ',' << t;
        } catch (const std::exception& error) {
            out << ",error," << error.what();
        }
        out << '\n';
    }
}
