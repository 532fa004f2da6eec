// GPU time between marks, by timestamp queries that are read late and never waited for.
#pragma once

#include <deque>
#include <vector>

#include "gl/handle.h"

namespace ballpit::gl {

inline void delete_query(GLuint id) { glDeleteQueries(1, &id); }
using Query = Handle<delete_query>;

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

    /// Spans whose queries have all arrived, oldest first.
    std::vector<Span> take();

private:
    struct Mark {
        int tag;
        Query query;
    };
    using Marks = std::vector<Mark>;

    Query stamp();

    Marks open_;
    std::deque<Marks> pending_;
    std::vector<Query> free_;
};

}  // namespace ballpit::gl
