#include "gl/timer.h"

#include <utility>

namespace ballpit::gl {

std::optional<std::uint64_t> elapsed_ns(std::uint64_t before, std::uint64_t now, int bits) {
    if (before == 0 || now == 0 || bits <= 0) {
        return std::nullopt;
    }
    const std::uint64_t half = std::uint64_t{1} << (bits - 1);
    const std::uint64_t ns = (now - before) & (half - 1 + half);
    return ns < half ? std::optional(ns) : std::nullopt;
}

Query SpanTimer::stamp() {
    Query query;
    if (free_.empty()) {
        GLuint id = 0;
        glGenQueries(1, &id);
        query = Query(id);
    } else {
        query = std::move(free_.back());
        free_.pop_back();
    }
    glQueryCounter(query.id(), GL_TIMESTAMP);
    return query;
}

void SpanTimer::begin() {
    open_.clear();
    open_.push_back({0, stamp()});
}

void SpanTimer::mark(int tag) { open_.push_back({tag, stamp()}); }

void SpanTimer::end() { pending_.push_back(std::exchange(open_, {})); }

std::optional<SpanTimer::Span> SpanTimer::read(const Marks& marks, int bits) {
    Span span;
    GLuint64 before = 0;
    for (const Mark& mark : marks) {
        GLuint64 now = 0;
        glGetQueryObjectui64v(mark.query.id(), GL_QUERY_RESULT, &now);
        if (&mark != &marks.front()) {
            const auto ns = elapsed_ns(before, now, bits);
            if (!ns) {
                return std::nullopt;
            }
            span.push_back({mark.tag, static_cast<double>(*ns) * 1e-6});
        }
        before = now;
    }
    return span;
}

std::vector<SpanTimer::Span> SpanTimer::take() {
    std::vector<Span> spans;
    GLint bits = 0;
    glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    while (!pending_.empty()) {
        Marks& marks = pending_.front();
        GLint available = 0;
        glGetQueryObjectiv(marks.back().query.id(), GL_QUERY_RESULT_AVAILABLE, &available);
        if (available == 0) {
            break;  // queries complete in order: the later ones are not there either
        }
        if (auto span = read(marks, bits)) {
            spans.push_back(*std::move(span));
        } else {
            ++lost_;
        }
        for (Mark& mark : marks) {
            free_.push_back(std::move(mark.query));
        }
        pending_.pop_front();
    }
    return spans;
}

std::size_t SpanTimer::take_lost() { return std::exchange(lost_, 0); }

}  // namespace ballpit::gl
