#pragma once
#include "debug/recording.h"
#include "worker/message.h"

namespace worker {

// It has a variant in it, which is read and written alternative by alternative.
template <> inline constexpr bool isVariant<debug::Shape> = true;

inline Message& operator<<(Message& message, const debug::Shape& shape)
{
    return message << shape.drawn << shape.cause;
}

inline Reader& operator>>(Reader& reader, debug::Shape& shape)
{
    return reader >> shape.drawn >> shape.cause;
}

}
