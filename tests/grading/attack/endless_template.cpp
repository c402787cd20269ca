// refused: has the compiler work until its memory or its time is over
template <int N> struct Twice {
    static constexpr unsigned long value = Twice<N - 1>::value + Twice<N - 2>::value * N;
};
template <typename... T> struct Grow : Grow<T..., T..., int> {
};

static glm::vec3 attack()
{
    return glm::vec3(static_cast<float>(sizeof(Grow<int>)));
}
