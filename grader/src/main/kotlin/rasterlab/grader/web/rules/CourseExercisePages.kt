// The page on which an instructor chooses the exercises of a course.
package rasterlab.grader.web.rules

import io.ktor.http.HttpStatusCode
import io.ktor.http.Parameters
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.TR
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.id
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.rules.CourseExercises
import rasterlab.grader.rules.CourseLimits
import rasterlab.grader.rules.CourseRules
import rasterlab.grader.rules.ExerciseRules
import rasterlab.grader.rules.LimitField
import rasterlab.grader.rules.RuleField
import rasterlab.grader.web.FORM_AGAIN
import rasterlab.grader.web.FormAgain
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.Refused
import rasterlab.grader.web.courseOf
import rasterlab.grader.web.instructorHere
import rasterlab.grader.web.problem
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.rulesAddress
import rasterlab.grader.web.scrolling
import rasterlab.grader.web.staffHere
import rasterlab.grader.web.texts

/** Shows staff the exercises of a course and their rules, and lets instructors choose which the course has. */
fun Route.courseExercisePages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    chosen: CourseExercises,
    rules: CourseRules,
    limits: CourseLimits,
) {
    get("/instructor/courses/{course}/exercises") {
        val who = call.staffHere(accounts)
        ExerciseTable(call.courseOf(courses), exercises, chosen, rules, limits).show(call, who, refused = null)
    }
    post("/instructor/courses/{course}/exercises") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val table = ExerciseTable(call.courseOf(courses), exercises, chosen, rules, limits)
        val form = call.receiveForm()
        table.showAgain(call, who, form)
        chosen.choose(table.course, if ("all" in form) null else form.getAll("exercise").orEmpty(), who.id)
        call.respondRedirect(table.address)
    }
    post("/instructor/courses/{course}/limits") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val table = ExerciseTable(call.courseOf(courses), exercises, chosen, rules, limits)
        val form = call.receiveForm()
        table.showAgain(call, who, form)
        limits.change(table.course, LimitField.entries.associateWith { form[it.code].orEmpty() }, who.id)
        call.respondRedirect("${table.address}#limits")
    }
}

private class ExerciseTable(
    val course: Course,
    private val exercises: Exercises,
    private val chosen: CourseExercises,
    private val rules: CourseRules,
    private val limits: CourseLimits,
) {
    val address = "/instructor/courses/${course.id}/exercises"

    /** Sees that what was typed stands in its fields again where it is refused. */
    fun showAgain(
        call: ApplicationCall,
        who: Identity.StaffIdentity,
        form: Parameters,
    ) = call.attributes.put(
        FORM_AGAIN,
        FormAgain { status, code, added -> show(call, who, Refused(status, code, added(call.texts().language)), form) },
    )

    suspend fun show(
        call: ApplicationCall,
        who: Identity.StaffIdentity,
        refused: Refused?,
        typed: Parameters? = null,
    ) {
        val texts = call.texts()
        val status = refused?.status ?: HttpStatusCode.OK
        call.respondPage(texts, who, texts.say("rules.title", course.name), status) {
            refused?.let { problem(texts, it.status, it.code, it.details) }
            p("ways") {
                a("/instructor") { +texts.say("token.back") }
                if (who is Identity.Instructor) a("#limits") { +texts.say("limits.heading") }
            }
            if (who is Identity.Instructor) choice(texts) else rows(texts, choosing = false)
            if (who is Identity.Instructor) limits(texts, typed)
        }
    }

    private fun FlowContent.limits(
        texts: PageTexts,
        typed: Parameters?,
    ) = section("card") {
        id = "limits"
        val own = limits.of(course).own
        val most = limits.most
        h2 { +texts.say("limits.heading") }
        p { +texts.say("limits.about", most.perMinute, most.waiting) }
        form("/instructor/courses/${course.id}/limits", method = FormMethod.post) {
            for ((field, allowed) in listOf(
                LimitField.PER_MINUTE to most.perMinute,
                LimitField.WAITING to most.waiting,
            )) {
                label {
                    +texts.say("limits.${field.code}")
                    input(InputType.number, name = field.code) {
                        min = "1"
                        max = "$allowed"
                        placeholder = "$allowed"
                        value = typed?.get(field.code) ?: own[field]?.coerceAtMost(allowed)?.toString().orEmpty()
                    }
                }
            }
            button { +texts.say("limits.save") }
        }
    }

    private fun FlowContent.choice(texts: PageTexts) =
        form(address, method = FormMethod.post) {
            p { +texts.say("rules.choice.about") }
            saving(texts)
            rows(texts, choosing = true)
            saving(texts)
        }

    /** Stands above the list and below it, which is longer than a window. */
    private fun FlowContent.saving(texts: PageTexts) =
        p("ways") {
            button { +texts.say("rules.choice.save") }
            button(classes = "plain") {
                name = "all"
                +texts.say("rules.choice.all")
            }
        }

    /** Writes the exercises of the course, then all others. */
    private fun FlowContent.rows(
        texts: PageTexts,
        choosing: Boolean,
    ) = scrolling(texts.say("rules.title", course.name)) {
        val had = chosen.of(course.id).toSet()
        val set = rules.ofCourse(course)
        table("ruled") {
            thead {
                tr {
                    val ruled = (RuleField.entries - RuleField.ZONE).map { "rules.column.${it.code}" }
                    (listOf("rules.column.chosen", "rules.exercise") + ruled + "rules.column.class").forEach {
                        th(scope = ThScope.col) { +texts.say(it) }
                    }
                }
            }
            tbody {
                exercises.all.sortedByDescending { it.id() in had }.forEach { exercise ->
                    tr {
                        td {
                            if (choosing) {
                                check(texts, exercise, exercise.id() in had)
                            } else if (exercise.id() in had) {
                                +"✓"
                            }
                        }
                        ruled(texts, exercise, set[exercise.id()] ?: ExerciseRules(), choosing)
                    }
                }
            }
        }
    }

    private fun FlowContent.check(
        texts: PageTexts,
        exercise: Exercise,
        isIn: Boolean,
    ) = input(InputType.checkBox, name = "exercise") {
        value = exercise.id()
        checked = isIn
        attributes["aria-label"] = texts.say("rules.choice.has", exercise.title(texts.language))
    }

    private fun TR.ruled(
        texts: PageTexts,
        exercise: Exercise,
        rules: ExerciseRules,
        changing: Boolean,
    ) {
        val title = exercise.title(texts.language)
        td { if (changing) a(rulesAddress(course, exercise)) { +title } else +title }
        td { +rules.opens?.let(texts::time).orEmpty() }
        td { +rules.due?.let(texts::time).orEmpty() }
        td { +rules.lateDays?.toString().orEmpty() }
        td { +rules.attempts?.toString().orEmpty() }
        td { +texts.say("rules.policy.${rules.policy.code}") }
        td { if (rules.latePenalty > 0) +"${rules.latePenalty}\u00a0%" }
        td {
            a("${rulesAddress(course, exercise)}/errors") {
                attributes["aria-label"] = "${texts.say("errors.heading")}: $title"
                +texts.say("errors.link")
            }
            if (exercise.form() == Exercise.TaskKind.WRITE) {
                +" "
                a("${rulesAddress(course, exercise)}/similarity") {
                    attributes["aria-label"] = "${texts.say("similarity.heading")}: $title"
                    +texts.say("similar.link")
                }
            }
        }
    }
}
