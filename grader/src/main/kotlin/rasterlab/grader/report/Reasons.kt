package rasterlab.grader.report

import rasterlab.exercises.Exercise
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.topic.CaseReasons
import rasterlab.grader.course.Identity
import java.util.concurrent.ConcurrentHashMap

/** Why hidden cases are there, worked out when somebody who may know asks first, and kept. */
class Reasons {
    private val known = ConcurrentHashMap<Pair<String, String>, CaseReasons>()

    /**
     * The reason in that language, or null where the exercise has no case of that name, or asks for
     * no method.
     */
    fun of(
        exercise: Exercise,
        case: String,
        language: String,
    ): String? {
        if (exercise.form() != Exercise.TaskKind.WRITE || exercise.cases().none { it.name() == case }) return null
        val reasons = known.computeIfAbsent(exercise.id() to exercise.revision()) { CaseReasons(exercise) }
        return reasons.of(case).`in`(language)
    }
}

/** Whether it is hidden, and yet these eyes see it whole. */
fun CaseReport.isOpenTo(
    who: Identity,
    due: Due,
) = when (visibility()) {
    Disclosure.OPEN -> false
    Disclosure.AFTER_DEADLINE -> who is Identity.StaffIdentity || due.passed
    else -> who is Identity.StaffIdentity
}
