// expansion.h - exact sums and products of doubles.
//
// An expansion represents a number as the sum of doubles (components) that do not overlap, smallest
// first, without zeros. Its sign is the sign of its last component.
// source  Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
//         Predicates", Discrete & Computational Geometry 18: two-sum (theorem 7), grow-expansion
//         (theorem 10), scale-expansion (theorem 19), compress (figure 15)
#pragma once

#include <cmath>

namespace firsthit {

struct DoubleSum {
    double high;
    double low; // high + low is the exact result
};

/// a + b, exactly, if nothing overflows.
inline DoubleSum two_sum(double a, double b)
{
    const double high = a + b;
    const double b_part = high - a;
    const double a_part = high - b_part;
    return {high, (a - a_part) + (b - b_part)};
}

/// a * b, exactly, if nothing under- or overflows.
inline DoubleSum two_product(double a, double b)
{
    const double high = a * b;
    return {high, std::fma(a, b, -high)};
}

/// An expansion of at most N components. Undefined if more than N doubles are added (a product adds
/// two): choose N by counting the calls of add().
template <int N>
class Expansion {
  public:
    int size() const { return size_; }
    double operator[](int i) const { return component_[i]; }

    int sign() const
    {
        if (size_ == 0) return 0;
        return component_[size_ - 1] > 0 ? 1 : -1;
    }

    /// The value as a double, to within two roundings.
    double estimate() const
    {
        double sum = 0;
        for (int i = 0; i < size_; ++i) sum += component_[i];
        return sum;
    }

    void add(double b)
    {
        double carry = b;
        int kept = 0;
        for (int i = 0; i < size_; ++i) {
            const DoubleSum s = two_sum(carry, component_[i]);
            carry = s.high;
            if (s.low != 0) component_[kept++] = s.low;
        }
        if (carry != 0) component_[kept++] = carry;
        size_ = kept;
    }

    void add_product(double a, double b)
    {
        const DoubleSum p = two_product(a, b);
        add(p.low);
        add(p.high);
    }

    template <int M>
    void add(const Expansion<M>& other)
    {
        for (int i = 0; i < other.size(); ++i) add(other[i]);
    }

    /// Adds factor * other.
    template <int M>
    void add_scaled(const Expansion<M>& other, double factor)
    {
        for (int i = 0; i < other.size(); ++i) add_product(other[i], factor);
    }

    /// Adds sign * a * b. Call compress() on a and b first, as the cost is the product of their
    /// sizes.
    template <int A, int B>
    void add_product(const Expansion<A>& a, const Expansion<B>& b, double sign)
    {
        for (int i = 0; i < a.size(); ++i)
            for (int j = 0; j < b.size(); ++j) add_product(sign * a[i], b[j]);
    }

    /// Reduces the number of components; the value stays the same.
    void compress()
    {
        if (size_ < 2) return;
        double packed[N];
        int bottom = size_ - 1;
        double q = component_[size_ - 1];
        for (int i = size_ - 2; i >= 0; --i) {
            const DoubleSum s = fast_two_sum(q, component_[i]);
            if (s.low != 0) {
                packed[bottom--] = s.high;
                q = s.low;
            } else {
                q = s.high;
            }
        }
        packed[bottom] = q;
        int kept = 0;
        q = packed[bottom];
        for (int i = bottom + 1; i < size_; ++i) {
            const DoubleSum s = fast_two_sum(packed[i], q);
            if (s.low != 0) component_[kept++] = s.low;
            q = s.high;
        }
        if (q != 0) component_[kept++] = q;
        size_ = kept;
    }

  private:
    /// a + b, exactly, for |a| >= |b|.
    static DoubleSum fast_two_sum(double a, double b)
    {
        const double high = a + b;
        return {high, b - (high - a)};
    }

    double component_[N];
    int size_ = 0;
};

} // namespace firsthit
