// Arrays between C++ and numpy: rows of numbers as they lie in memory.
#pragma once

#include <boost/python.hpp>

#include <cstring>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace yade {

// As bytes, for numpy.frombuffer.
template <class Row> boost::python::object bytesOf(const std::vector<Row>& rows)
{
	const char* begin = reinterpret_cast<const char*>(rows.data());
	return boost::python::object(boost::python::handle<>(PyBytes_FromStringAndSize(begin, Py_ssize_t(rows.size() * sizeof(Row)))));
}

// Of bytes or a contiguous array; ValueError unless it is a whole number of rows.
template <class Row> std::vector<Row> rowsOf(const boost::python::object& source, const char* name)
{
	Py_buffer view;
	if (PyObject_GetBuffer(source.ptr(), &view, PyBUF_C_CONTIGUOUS) != 0) boost::python::throw_error_already_set();
	const auto size = std::size_t(view.len);
	std::vector<Row> rows(size / sizeof(Row));
	if (!rows.empty()) std::memcpy(static_cast<void*>(rows.data()), view.buf, rows.size() * sizeof(Row));
	PyBuffer_Release(&view);
	if (size % sizeof(Row) == 0) return rows;
	std::ostringstream message;
	message << name << " = " << size << " bytes: must be rows of " << sizeof(Row) << " bytes";
	throw std::invalid_argument(message.str());
}

} // namespace yade
