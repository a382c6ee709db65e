#pragma once
// An implicit function as what refinement asks.

#include <burin/base/run_context.h>

#include "refine.h"
#include "sizing.h"

#include <memory>

namespace burin {

/// Thrown where refinement asks for more than a surface of the expected size needs: a function
/// without end.
struct BudgetSpent {};

/// Signs by intervals where these tell, else by the function restricted to a cell. Polls the
/// context and tells it the share done.
class FunctionField final : public RefineField {
 public:
  FunctionField(const ImplicitFunction& f, const Box3& box, const Sizing& sizing,
                std::size_t most_vertices, RunContext& context);

  bool inside(Vec3 p) override;
  Vec3 crossing(Vec3 a, Vec3 b) override;
  double radius(Vec3 p) override;
  double edge(Vec3 p) override;

 private:
  struct Cell {
    enum : std::uint8_t { Unseen, Inside, Outside, Mixed } state = Unseen;
    const ImplicitFunction* function = nullptr;
    std::shared_ptr<const ImplicitFunction> own;
  };
  const Cell& cell_at(Vec3 p);
  double value(const Cell& cell, Vec3 p);
  void count();
  void clip(Vec3 inner, Vec3& end) const;

  const ImplicitFunction& f_;
  Box3 box_;
  const Sizing& sizing_;
  RunContext& context_;
  double step_ = 1, size_ = 1;
  glm::ivec3 count_{1};
  std::vector<Cell> cells_;
  // Signs asked again and again: of the centres of tetrahedra.
  struct Known {
    Vec3 p{0};
    bool known = false, inside = false;
  };
  std::vector<Known> known_;
  std::size_t evaluations_ = 0, crossings_ = 0, budget_ = 0;
};

}  // namespace burin
