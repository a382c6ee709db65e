#pragma once
/// The secant rule in the form of Illinois: it keeps a bracket around a change of sign.
/// @cite Dowell1971

namespace burin {

/// Shares of a segment between which a function changes its sign, with its values there. An end
/// that stays twice in a row has its value halved, so that both ends move.
class IllinoisBracket {
 public:
  IllinoisBracket(double low, double high, double f_low, double f_high)
      : low_(low), high_(high), f_low_(f_low), f_high_(f_high) {}

  double low() const { return low_; }
  double high() const { return high_; }
  double size() const { return high_ - low_; }
  double middle() const { return 0.5 * (low_ + high_); }

  /// Where to look in round `i`: the zero of the secant; the middle where that is of no use (it
  /// lies outside, or is no number), and in every fourth round, so that the bracket does shrink.
  double trial(int i) const {
    const double share = low_ + (high_ - low_) * (f_low_ / (f_low_ - f_high_));
    return !(share > low_ && share < high_) || i % 4 == 3 ? middle() : share;
  }
  /// Moves an end to `share`, where the function is `v`: the low one where `v` has its sign.
  void move(double share, double v, bool as_low) {
    if (as_low) {
      low_ = share;
      f_low_ = v;
      kept_ = kept_ > 0 ? kept_ + 1 : 1;
      if (kept_ > 1) f_high_ *= 0.5;
    } else {
      high_ = share;
      f_high_ = v;
      kept_ = kept_ < 0 ? kept_ - 1 : -1;
      if (kept_ < -1) f_low_ *= 0.5;
    }
  }

 private:
  double low_, high_, f_low_, f_high_;
  /// How often in a row the low end (counted up from 0) or the high end (down) has moved.
  int kept_ = 0;
};

}  // namespace burin
