// How text is spelled in bytes: marks, UTF-16, line ends, and names that must be shown.
#pragma once

#include <string>
#include <string_view>

#include "hodt/io/input_text.h"

namespace hodt {

/// Drops a byte order mark; UTF-16 that has one becomes UTF-8. Leaves room for the padding, which
/// the caller writes.
void decode(InputText& input);

/// Makes a line feed of each lone carriage return if that is how the first line ends: old Macs
/// wrote no line feeds.
void mend_line_ends(InputText& input);

/// The text in valid UTF-8 without control characters, for messages and reports. Bytes that are no
/// UTF-8 are taken for Latin-1.
std::string readable(std::string_view text);

/// The same, short enough for a message, in quotes.
std::string in_quotes(std::string_view text);

/// Appends a code point in UTF-8.
void append_utf8(std::string& text, char32_t point);

/// Takes the first code point off the front of the text, which is not empty. A byte that is no
/// UTF-8 is taken for Latin-1.
char32_t take_code_point(std::string_view& text);

}  // namespace hodt
