#pragma once

// One callable from several lambdas, for std::visit.
template <typename... Lambdas> struct Visitor : Lambdas... {
    using Lambdas::operator()...;
};

template <typename... Lambdas> [[nodiscard]] constexpr auto make_visitor(Lambdas... lambdas)
{
    return Visitor<Lambdas...> { lambdas... };
}
