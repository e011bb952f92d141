#include "gui/app/problems.h"

#include <algorithm>

#include "gui/app/text.h"
#include "tracer/io/scene_check.h"

namespace glint {

QString newProblem(const Scene& before, const Scene& after) {
    const std::vector<Error> problems = sceneProblems(after);
    if (problems.empty()) return {};
    const std::vector<Error> old = sceneProblems(before);
    for (const Error& problem : problems) {
        if (std::find(old.begin(), old.end(), problem) != old.end()) continue;
        QString text = toQString(problem.message);
        if (!text.isEmpty()) text[0] = text[0].toUpper();
        return problem.remedy.empty() ? text
                                      : text + QStringLiteral(": ") + toQString(problem.remedy);
    }
    return {};
}

}  // namespace glint
