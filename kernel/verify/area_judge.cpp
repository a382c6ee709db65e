#include <burin/feature/light_normals.h>
#include <burin/verify/areas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace burin {
namespace {

// Paper mm: nearer to a border a place may count to either side.
constexpr double kBesideBorder = 0.12;
constexpr int kJudgedDirections = 12;

}  // namespace

const char* to_string(AreaFinding finding) {
  switch (finding) {
    case AreaFinding::Holds:
      return "holds";
    case AreaFinding::WrongPart:
      return "wrong_part";
    case AreaFinding::WrongFace:
      return "wrong_face";
    case AreaFinding::WrongTone:
      return "wrong_tone";
  }
  return "";
}

AreaJudge::AreaJudge(const AreaRule& rule, const AreaWitnesses& witnesses,
                     const RunContext& context)
    : rule_(rule), witnesses_(witnesses), areas_(rule.areas, kBesideBorder) {
  const Referee& toned = witnesses.toned ? *witnesses.toned : witnesses.solid;
  normals_.resize(toned.surfaces().size());
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    const auto& surface = toned.surfaces()[i];
    const bool steps = i < rule.tones.size() && !rule.tones[i].levels.empty();
    if (!steps || !surface || surface->exact()) continue;
    normals_[i] = tone_normals(surface->proxy(), rule.tones[i], toned.camera(), rule.pen, context);
  }
}

bool AreaJudge::is_glass(std::int32_t part) const {
  const auto i = static_cast<std::size_t>(part);
  return part >= 0 && i < rule_.glass.size() && rule_.glass[i];
}

AreaJudge::Claim AreaJudge::claim(Vec2 p) const {
  Claim claim;
  for (const std::size_t k : areas_.at(p)) {
    const Area& area = rule_.areas[k];
    if (area.part < 0) continue;  // a shadow on the ground, below all parts
    if (is_glass(area.part)) {
      claim.glass.push_back(area.part);
    } else {
      claim.solid = {area.part, area.face, area.tone};  // what is painted last
    }
  }
  return claim;
}

/// The least and the most that the step of a sheet may be.
std::pair<std::int32_t, std::int32_t> AreaJudge::tones_of(const Referee::Sheet& sheet) const {
  const auto [least, most] = lit_tones_of(sheet);
  if (!rule_.shadows || most <= 0 || sheet.cut) return {least, most};
  const Referee& casting = witnesses_.casting ? *witnesses_.casting : witnesses_.solid;
  switch (witnesses_.solid.shade(sheet, *rule_.shadows, casting)) {
    case Referee::Shade::Lit:
      return {least, most};
    case Referee::Shade::Shaded:
      return {0, 0};
    case Referee::Shade::Unsure:
      break;
  }
  return {0, most};
}

/// The normals that decide the tone of a sheet of a mesh: at its place, and at the corners of its
/// triangle. They are those of the mesh as coarse as it was drawn, if that is found there.
std::array<Vec3, 4> AreaJudge::lit_normals(const Referee::Sheet& sheet) const {
  const auto part = static_cast<std::size_t>(sheet.part);
  const Referee* referee = &witnesses_.solid;
  Referee::Sheet at = sheet;
  std::span<const Vec3> normals;
  if (!witnesses_.toned) {
    normals = normals_[part];
  } else {
    const Vec2 paper = witnesses_.solid.camera().to_paper(sheet.place);
    witnesses_.toned->may_see(paper, [&](const Referee::Sheet& coarse) {
      if (coarse.part != sheet.part) return false;
      referee = witnesses_.toned;
      at = coarse;
      normals = normals_[part];
      return true;
    });
  }
  std::array<Vec3, 4> out{referee->normal(at, normals)};
  for (int corner = 0; corner < 3; ++corner) {
    at.point.bary = Vec3(0);
    at.point.bary[corner] = 1;
    out[static_cast<std::size_t>(corner) + 1] = referee->normal(at, normals);
  }
  return out;
}

/// The same where nothing casts a shadow.
std::pair<std::int32_t, std::int32_t> AreaJudge::lit_tones_of(const Referee::Sheet& sheet) const {
  const Isophotes& tones = rule_.tones[static_cast<std::size_t>(sheet.part)];
  const auto lightest = static_cast<std::int32_t>(tones.levels.size());
  // The face that closes a cut is none of the shape: it is lit in full.
  if (sheet.cut) return {lightest, lightest};
  const auto one = [&](Vec3 normal) {
    const std::int32_t tone = step_of(tones, normal);
    return std::pair(tone, tone);
  };
  if (sheet.exact) return one(witnesses_.solid.normal(sheet, {}));
  const std::array<Vec3, 4> normals = lit_normals(sheet);
  if (rule_.facet_light <= 0) return one(normals[0]);
  // Of noise no normal is the right one: any between the corners may be.
  const Vec3 light = glm::normalize(tones.light);
  const auto [least, most] =
      std::ranges::minmax(normals, {}, [&](const Vec3& normal) { return glm::dot(normal, light); });
  const Vec3 more = rule_.facet_light * light;
  return {step_of(tones, least - more), step_of(tones, most + more)};
}

AreaAnswer AreaJudge::ask_solid(const AreaFacts& stated, Vec2 paper) const {
  AreaAnswer answer{AreaFinding::Holds, stated, {}, {}};
  if (stated.part >= 0 && witnesses_.with && !witnesses_.with(stated.part)) return answer;
  AreaFinding nearest = AreaFinding::WrongPart;
  bool any = false;
  const bool holds = witnesses_.solid.may_see(paper, [&](const Referee::Sheet& sheet) {
    const auto part = static_cast<std::size_t>(sheet.part);
    AreaFacts seen{sheet.part, sheet.face, -1};
    AreaFinding finding = AreaFinding::Holds;
    if (stated.part != sheet.part) {
      finding = AreaFinding::WrongPart;
    } else if (stated.face >= 0 && stated.face != sheet.face) {
      finding = AreaFinding::WrongFace;
    } else if (stated.tone >= 0 && part < rule_.tones.size()) {
      const auto [least_tone, most_tone] = tones_of(sheet);
      seen.tone = stated.tone > most_tone ? most_tone : least_tone;
      if (stated.tone < least_tone || stated.tone > most_tone) finding = AreaFinding::WrongTone;
    }
    if (!any || finding > nearest) {
      nearest = finding;
      answer.seen = seen;
      answer.model = sheet.place;
    }
    any = true;
    return finding == AreaFinding::Holds;
  });
  if (holds || (!any && stated.part < 0)) return answer;
  answer.finding = nearest;
  return answer;
}

// Glass is seen where nothing solid stands before it; what stands behind other glass may be left
// out.
AreaAnswer AreaJudge::ask_glass(const Claim& claim, Vec2 paper) const {
  for (const std::int32_t part : claim.glass) {
    const Referee* with = witnesses_.with ? witnesses_.with(part) : nullptr;
    const auto is_it = [&](const Referee::Sheet& sheet) { return sheet.part == part; };
    if (!with || with->may_see(paper, is_it)) continue;
    return {AreaFinding::WrongPart, {part, -1, -1}, {}, {}};
  }
  // A pane behind others is seen, too.
  for (std::int32_t part = 0; part < std::ssize(rule_.glass); ++part) {
    if (!is_glass(part) || std::ranges::find(claim.glass, part) != claim.glass.end()) continue;
    const Referee* with = witnesses_.with ? witnesses_.with(part) : nullptr;
    const auto seen = with ? with->see(paper) : std::nullopt;
    const auto is_other = [&](const Referee::Sheet& sheet) { return sheet.part != part; };
    if (!seen || with->may_see(paper, is_other)) continue;
    return {AreaFinding::WrongPart, {}, {part, seen->source.face, -1}, seen->place};
  }
  AreaAnswer answer;
  const bool holds = witnesses_.all.may_see(paper, [&](const Referee::Sheet& sheet) {
    answer = {AreaFinding::WrongPart, {}, {sheet.part, sheet.face, -1}, sheet.place};
    return !is_glass(sheet.part) || std::ranges::find(claim.glass, sheet.part) != claim.glass.end();
  });
  if (holds || answer.seen.part < 0) answer.finding = AreaFinding::Holds;
  return answer;
}

AreaAnswer AreaJudge::ask(const Claim& claim, Vec2 paper) const {
  AreaAnswer answer = ask_solid(claim.solid, paper);
  if (answer.finding != AreaFinding::Holds || rule_.glass.empty()) return answer;
  return ask_glass(claim, paper);
}

AreaAnswer AreaJudge::at(Vec2 paper) const { return ask(claim(paper), paper); }

bool AreaJudge::beside_border(Vec2 paper) const { return areas_.beside_border(paper); }

AreaAnswer AreaJudge::test(Vec2 paper) const {
  const Claim stated = claim(paper);
  AreaAnswer answer = ask(stated, paper);
  if (answer.finding == AreaFinding::Holds) return answer;
  const AreaAnswer holds{AreaFinding::Holds, answer.stated, answer.seen, answer.model};
  if (beside_border(paper)) return holds;
  for (const double share : {0.5, 1.0}) {
    for (int i = 0; i < kJudgedDirections; ++i) {
      const double a = 2 * std::numbers::pi * i / kJudgedDirections;
      const Vec2 there = paper + share * witnesses_.all.radius() * Vec2(std::cos(a), std::sin(a));
      if (ask(stated, there).finding == AreaFinding::Holds) return holds;
    }
  }
  return answer;
}

}  // namespace burin
