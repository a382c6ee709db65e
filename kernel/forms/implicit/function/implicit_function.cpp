#include <burin/forms/implicit/implicit_function.h>

namespace burin {

double ImplicitFunction::value(Vec3 p) const {
  double v = 0;
  values({&p, 1}, {&v, 1});
  return v;
}
Gradient1 ImplicitFunction::gradient(Vec3 p) const {
  Gradient1 g;
  gradients({&p, 1}, {&g, 1});
  return g;
}
Gradient2 ImplicitFunction::hessian(Vec3 p) const {
  Gradient2 h;
  hessians({&p, 1}, {&h, 1});
  return h;
}

}  // namespace burin
