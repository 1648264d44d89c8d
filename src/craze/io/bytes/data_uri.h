// URIs that hold their bytes (RFC 2397).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace craze {

/// Whether a URI holds its bytes itself ("data:", in capitals or not).
bool is_data_uri(std::string_view uri);
/// The media type that such a URI gives; "" where it gives none.
std::string_view data_uri_type(std::string_view uri);
/// Its bytes; empty optional where they are not base64.
std::optional<std::string> decode_data_uri(std::string_view uri);

}  // namespace craze
