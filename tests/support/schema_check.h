// Documents against the published schemas of resources/schema, by valijson. Of test programs alone.
#pragma once

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <fstream>
#include <string>

namespace vp::test {

/// "" if the document fits the schema of this kind ("mission", "plan", ...), else each place with what is wrong there.
inline std::string schemaMisfit(const std::string& kind, const nlohmann::json& document) {
  std::ifstream file(VOLPLANE_SOURCE_DIR "/resources/schema/" + kind + ".schema.json");
  const nlohmann::json schemaJson = nlohmann::json::parse(file);
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schemaJson), schema);
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results)) {
    return {};
  }
  std::string text;
  valijson::ValidationResults::Error error;
  while (results.popError(error)) {
    for (const std::string& part : error.context) {
      text += part;
    }
    text += ": " + error.description + "\n";
  }
  return text;
}

}  // namespace vp::test
