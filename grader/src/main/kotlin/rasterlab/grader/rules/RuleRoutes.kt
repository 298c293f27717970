package rasterlab.grader.rules

import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.patch
import io.ktor.server.routing.put
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.exercises.json.JsonFields
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.instructor
import rasterlab.grader.course.staff
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.language
import rasterlab.grader.problem.linkNext
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.typed
import rasterlab.grader.storage.text

@Serializable
private data class RulesAnswer(
    val exercise: String,
    val opens: String?,
    val deadline: String?,
    val zone: String,
    val lateDays: Int?,
    val attempts: Int?,
    val policy: String,
    val latePenalty: Int,
    val inCourse: Boolean,
    val notes: List<String>,
)

@Serializable
private data class ExtensionAnswer(
    val student: String,
    val exercise: String,
    val deadline: String?,
    val notes: List<String>,
)

@Serializable
private data class GivenExtension(
    val student: String,
    val name: String,
    val exercise: String,
    val deadline: String,
    val reason: String,
)

@Serializable
private data class AllRulesAnswer(
    val exercises: List<RulesAnswer>,
    val extensions: List<GivenExtension>,
    val next: String?,
)

/**
 * Serves the rules of exercises to staff, inside `authenticate`, and lets instructors change them.
 *
 * @param ids of the exercises there are
 * @param known throws the rejection of an exercise that there is not
 */
fun Route.exerciseRules(
    courses: Courses,
    rules: CourseRules,
    chosen: CourseExercises,
    ids: List<String>,
    known: (String) -> Unit,
) {
    get("/courses/{course}/exercises") {
        call.staff()
        val course = call.course(courses)
        val set = rules.ofCourse(course)
        val had = chosen.of(course.id).toSet()
        val language = call.language()
        val part = call.paging(Paging.WHOLE).of(ids) { it }
        val elsewhere = ids - part.items.toSet()
        val extensions = rules.extensions(course).filter { it.exercise !in elsewhere }
        call.linkNext(part)
        call.respondJson(
            AllRulesAnswer(
                part.items.map { answer(it, set[it] ?: ExerciseRules(), it in had, language) },
                extensions.map { GivenExtension(it.student, it.name, it.exercise, it.due.text(), it.reason) },
                part.next,
            ),
        )
    }
    patch("/courses/{course}/exercises/{id}") {
        val instructor = call.instructor()
        val exercise = call.parameters.getOrFail("id").also(known)
        val change = call.receiveJson(*CODES) { RuleChange(told(it)) }
        val course = call.course(courses)
        val after = rules.change(course, exercise, change, instructor.id)
        call.respondJson(answer(exercise, after, exercise in chosen.of(course.id), call.language()))
    }
    put("/courses/{course}/exercises/{id}/extensions/{student}") {
        val instructor = call.instructor()
        val exercise = call.parameters.getOrFail("id").also(known)
        val student = call.parameters.getOrFail("student")
        val (until, reason) =
            call.receiveJson("deadline", "reason") {
                it.anyText("deadline") to if (it.has("reason")) it.anyText("reason") else ""
            }
        val holds = rules.extend(call.course(courses), exercise, student, until, reason, instructor.id)
        val notes =
            RepeatedHour.among(holds.zone, RuleField.DEADLINE.code to holds.due).said(call.language())
        call.respondJson(ExtensionAnswer(student, exercise, holds.due?.text(), notes))
    }
}

private val CODES = RuleField.entries.map { it.code }.toTypedArray()

/** The fields as texts; a number or null may stand for what is one. */
private fun told(body: JsonFields): Map<RuleField, String> =
    RuleField.entries.filter { body.tree().has(it.code) }.associateWith { typed(it.code, body.tree().get(it.code)) }

private fun answer(
    exercise: String,
    rules: ExerciseRules,
    inCourse: Boolean,
    language: String,
) = RulesAnswer(
    exercise,
    rules.opens?.text(),
    rules.due?.text(),
    rules.zone.named(),
    rules.lateDays,
    rules.attempts,
    rules.policy.code,
    rules.latePenalty,
    inCourse,
    RepeatedHour.among(rules).said(language),
)
