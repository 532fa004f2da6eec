// Bytes as text that survives a chat window, a mail and a shell: base64 with - and _, without padding (RFC 4648, 5).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ballpit::app {

std::string base64url(const std::vector<unsigned char>& bytes);

/// Nothing where the text is no base64url: another letter, a length that no bytes have, bits that are left over.
std::optional<std::vector<unsigned char>> parse_base64url(std::string_view text);

}  // namespace ballpit::app
