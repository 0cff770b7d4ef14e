#include "splinecore/exchange/json.hpp"

#include "finding.hpp"
#include "targets.hpp"

namespace splinecore::fuzz {

void json(Input data) {
  attempt([&] {
    const Document document = from_json(Bytes(data).rest());
    const std::string text = to_json(document);
    demand(from_json(text) == document, "what was written is not what was read: " + text);
    demand(to_json(from_json(text)) == text, "a second text differs from the first: " + text);
  });
}

}  // namespace splinecore::fuzz
