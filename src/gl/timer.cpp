#include "gl/timer.h"

#include <utility>

namespace ballpit::gl {

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

std::vector<SpanTimer::Span> SpanTimer::take() {
    std::vector<Span> spans;
    while (!pending_.empty()) {
        Marks& marks = pending_.front();
        GLint available = 0;
        glGetQueryObjectiv(marks.back().query.id(), GL_QUERY_RESULT_AVAILABLE, &available);
        if (available == 0) {
            break;  // queries complete in order: the later ones are not there either
        }
        Span span;
        GLuint64 before = 0;
        for (Mark& mark : marks) {
            GLuint64 now = 0;
            glGetQueryObjectui64v(mark.query.id(), GL_QUERY_RESULT, &now);
            if (&mark != &marks.front()) {
                span.push_back({mark.tag, static_cast<double>(now - before) * 1e-6});
            }
            before = now;
            free_.push_back(std::move(mark.query));
        }
        spans.push_back(std::move(span));
        pending_.pop_front();
    }
    return spans;
}

}  // namespace ballpit::gl
