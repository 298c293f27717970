package rasterlab.grader.web

import io.ktor.http.HttpStatusCode
import io.ktor.http.Parameters
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.a
import kotlinx.html.p
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.rules.CourseRules
import rasterlab.grader.rules.ExerciseRules
import rasterlab.grader.rules.RepeatedHour
import rasterlab.grader.rules.RuleChange
import rasterlab.grader.rules.RuleField
import rasterlab.grader.rules.said

/** Shows instructors what a course rules for an exercise, and takes their changes. */
fun Route.rulesPages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    rules: CourseRules,
) {
    get("/instructor/courses/{course}/exercises/{id}") {
        val who = call.instructorHere(accounts)
        val desk = RulesDesk(call.courseOf(courses), call.exerciseOf(exercises), courses, rules)
        desk.show(call, who, typed = null, refused = null)
    }
    post("/instructor/courses/{course}/exercises/{id}") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val desk = RulesDesk(call.courseOf(courses), call.exerciseOf(exercises), courses, rules)
        val form = call.receiveForm()
        desk.showAgain(call, who, form)
        rules.change(desk.course, desk.exercise.id(), RuleChange(form.rules()), who.id)
        call.respondRedirect(desk.address)
    }
    post("/instructor/courses/{course}/exercises/{id}/extensions") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val desk = RulesDesk(call.courseOf(courses), call.exerciseOf(exercises), courses, rules)
        val form = call.receiveForm()
        desk.showAgain(call, who, form)
        val (student, until, reason) = listOf("student", "until", "reason").map { form[it].orEmpty() }
        rules.extend(desk.course, desk.exercise.id(), student, until, reason, who.id)
        call.respondRedirect(desk.address)
    }
}

internal fun ApplicationCall.exerciseOf(exercises: Exercises) = exercises.named(parameters.getOrFail("id"))

/** The course that the address names. */
internal fun ApplicationCall.courseOf(courses: Courses): Course {
    val told = parameters.getOrFail("course")
    return courses.find(told) ?: throw Rejection.UnknownCourse(told)
}

/** The rules that a form tells. */
private fun Parameters.rules(): Map<RuleField, String> =
    RuleField.entries.mapNotNull { field -> get(field.code)?.let { field to it } }.toMap()

internal fun rulesAddress(
    course: Course,
    exercise: Exercise,
) = "/instructor/courses/${course.id}/exercises/${exercise.id()}"

/** The page of one exercise's rules in one course. */
internal class RulesDesk(
    val course: Course,
    val exercise: Exercise,
    private val courses: Courses,
    private val rules: CourseRules,
) {
    val address = rulesAddress(course, exercise)

    /** Has what was typed shown again where what [call] goes on to do with it is refused. */
    fun showAgain(
        call: ApplicationCall,
        who: Identity.Instructor,
        typed: Parameters,
    ) = call.attributes.put(
        FORM_AGAIN,
        FormAgain { status, code, added ->
            show(call, who, typed, Refused(status, code, added(call.texts().language)))
        },
    )

    /** @param typed what a form told that was refused, or null */
    suspend fun show(
        call: ApplicationCall,
        who: Identity.Instructor,
        typed: Parameters?,
        refused: Refused?,
    ) {
        val texts = call.texts()
        val held = rules.ofCourse(course)[exercise.id()] ?: ExerciseRules()
        val extensions = rules.extensions(course).filter { it.exercise == exercise.id() }
        val heading = "${exercise.title(texts.language)} — ${course.name}"
        call.respondPage(texts, who, heading, refused?.status ?: HttpStatusCode.OK) {
            refused?.let { problem(texts, it.status, it.code, it.details) }
            p("ways") {
                a("/instructor/courses/${course.id}/exercises") { +texts.say("rules.back") }
                a("$address/regrade") { +texts.say("regrade.heading") }
            }
            (RepeatedHour.among(held) + extensions.flatMap { RepeatedHour.among(held.zone, it.name to it.due) })
                .said(texts.language)
                .forEach { p("plan") { +it } }
            rulesForm(texts, address, held, typed)
            extensionForms(texts, address, courses.students(course.id).orEmpty(), extensions, held, typed)
        }
    }
}
