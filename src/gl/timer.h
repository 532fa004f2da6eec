// GPU time between marks, by timestamp queries that are read late and never waited for.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "gl/handle.h"

namespace ballpit::gl {

inline void delete_query(GLuint id) { glDeleteQueries(1, &id); }
using Query = Handle<delete_query>;

/// ns between two stamps of a counter of so many bits, which begins anew when it is full (Intel's has 36). Nothing
/// where that cannot be: a query that was not carried out gives 0, and a stamp before the one that it follows would be
/// half of all that the counter can count. A driver (NVIDIA 580.159, behind a dispatch of seconds) was seen to give 0.
std::optional<std::uint64_t> elapsed_ns(std::uint64_t before, std::uint64_t now, int bits);

/// A span is a begin mark and any number of further marks, each with a number of the caller's that names what
/// went on since the mark before.
class SpanTimer {
public:
    struct Part {
        int tag;
        double ms;
    };
    using Span = std::vector<Part>;

    void begin();
    void mark(int tag);
    void end();

    /// Spans whose queries have all arrived, oldest first, without those in which a stamp cannot be true.
    std::vector<Span> take();
    /// How many of those there were since the last call.
    std::size_t take_lost();

private:
    struct Mark {
        int tag;
        Query query;
    };
    using Marks = std::vector<Mark>;

    Query stamp();
    /// Nothing where a stamp cannot be true.
    static std::optional<Span> read(const Marks& marks, int bits);

    Marks open_;
    std::deque<Marks> pending_;
    std::vector<Query> free_;
    std::size_t lost_ = 0;
};

}  // namespace ballpit::gl
