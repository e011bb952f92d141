// A validator for the part of JSON Schema that Glint's schema uses.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace glint::test {

/// Empty if `value` follows `schema`, else what does not and where. An unknown keyword in the
/// schema is a fault too.
[[nodiscard]] std::string schemaFault(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace glint::test
