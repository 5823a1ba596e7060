// The shape classes of the accuracy tables, and where the tables are written: SUPERQUADRIC_ACCURACY_TABLE=FOLDER asks for them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace superquadric::testing {

struct ShapeClass {
	const char* name;
	std::array<double, 2> exponents; // n1, n2
};

const ShapeClass shapeClasses[] = { { "ellipsoid 2/2", { 2, 2 } }, { "4/4", { 4, 4 } }, { "odd 3.3/5.7", { 3.3, 5.7 } },
	{ "cylinder 8/2", { 8, 2 } }, { "block 8/8", { 8, 8 } }, { "sharp block 20/20", { 20, 20 } } };

inline double worst(const std::vector<double>& errors) { return *std::max_element(errors.begin(), errors.end()); }

inline double median(std::vector<double> errors)
{
	std::nth_element(errors.begin(), errors.begin() + long(errors.size() / 2), errors.end());
	return errors[errors.size() / 2];
}

// A table in Markdown. Errors are written to one digit: the next ones depend on the processor.
class AccuracyTable {
public:
	explicit AccuracyTable(const std::string& heading)
	{
		text_ << "| " << heading << " |\n|";
		for (long i = std::count(heading.begin(), heading.end(), '|'); i >= 0; --i)
			text_ << " --- |";
		text_ << '\n'
		      << std::scientific << std::setprecision(0);
	}

	AccuracyTable& operator<<(const std::string& cell)
	{
		text_ << (rowOpen_ ? " | " : "| ") << cell;
		rowOpen_ = true;
		return *this;
	}
	AccuracyTable& operator<<(double error)
	{
		std::ostringstream digits;
		digits << std::scientific << std::setprecision(0) << error;
		return *this << digits.str();
	}
	void endRow()
	{
		text_ << " |\n";
		rowOpen_ = false;
	}

	void writeTo(const std::string& file) const
	{
		if (const char* folder = std::getenv("SUPERQUADRIC_ACCURACY_TABLE")) std::ofstream(std::string(folder) + "/" + file) << text_.str();
	}

private:
	std::ostringstream text_;
	bool rowOpen_ = false;
};

} // namespace superquadric::testing
