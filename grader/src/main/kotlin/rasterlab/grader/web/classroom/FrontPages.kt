package rasterlab.grader.web.classroom

import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.TD
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.details
import kotlinx.html.figcaption
import kotlinx.html.figure
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.summary
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import kotlinx.html.unsafe
import rasterlab.engine.Topics
import rasterlab.exercises.Exercise
import rasterlab.exercises.score.SpeedPoints
import rasterlab.grader.classroom.ClassFront
import rasterlab.grader.classroom.FrontPoint
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.similarity.written
import rasterlab.grader.web.ChartPoint
import rasterlab.grader.web.ChartScale
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.SpeedDrawing
import rasterlab.grader.web.courseOf
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.scrolling
import rasterlab.grader.web.staffHere
import rasterlab.grader.web.studentHere
import rasterlab.grader.web.texts

/** Shows speed against accuracy of a class: to a student the own place and others without names, to staff the names. */
fun Route.frontPages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    front: ClassFront,
) {
    get("/exercises/{id}/front") {
        val student = call.studentHere(accounts)
        val exercise = exercises.written(call.parameters.getOrFail("id"))
        val places = front.seenBy(student.id, courses.ofStudent(student.id)?.id.orEmpty(), exercise)
        call.respondOwnPlace(student, exercise, places, front.names(student.id))
    }
    post("/exercises/{id}/front") {
        call.requireOwnForm()
        val student = call.studentHere(accounts)
        val exercise = exercises.written(call.parameters.getOrFail("id"))
        front.name(student.id, call.receiveForm()["named"] == "yes")
        call.respondRedirect("/exercises/${exercise.id()}/front")
    }
    get("/instructor/courses/{course}/exercises/{id}/front") {
        val who = call.staffHere(accounts)
        val course = call.courseOf(courses)
        val exercise = exercises.written(call.parameters.getOrFail("id"))
        call.respondFront(who, course, exercise, front.of(course.id, exercise))
    }
}

private suspend fun ApplicationCall.respondOwnPlace(
    student: Identity.StudentIdentity,
    exercise: Exercise,
    places: List<FrontPoint>,
    named: Boolean,
) {
    val texts = texts()
    respondPage(texts, student, "${texts.say("front.heading")}: ${exercise.title(texts.language)}") {
        p { a("/exercises/${exercise.id()}") { +texts.say("front.back") } }
        p("plan") { +texts.say("front.anonymous") }
        if (places.count { !it.named } < ClassFront.LEAST) p { +texts.say("front.few", ClassFront.LEAST) }
        classChart(texts, exercise, places, student.id) { place, own ->
            +(
                if (own) {
                    texts.say("chart.own")
                } else if (place.named) {
                    place.name
                } else {
                    texts.say("front.other")
                }
            )
        }
        naming(texts, exercise, student, named)
    }
}

/** Lets the student have the class read the name on its charts, or no longer. */
private fun FlowContent.naming(
    texts: PageTexts,
    exercise: Exercise,
    student: Identity.StudentIdentity,
    named: Boolean,
) = section("card apart") {
    h2 { +texts.say("front.name") }
    p { +texts.say(if (named) "front.name.shown" else "front.name.hidden", student.name) }
    form("/exercises/${exercise.id()}/front", method = FormMethod.post) {
        button {
            name = "named"
            value = if (named) "no" else "yes"
            +texts.say(if (named) "front.name.hide" else "front.name.show")
        }
    }
}

private suspend fun ApplicationCall.respondFront(
    who: Identity.StaffIdentity,
    course: Course,
    exercise: Exercise,
    places: List<FrontPoint>,
) {
    val texts = texts()
    respondPage(texts, who, "${texts.say("front.heading")}: ${exercise.title(texts.language)} — ${course.name}") {
        waysOfClass(texts, course, exercise, "front")
        if (places.isEmpty()) p { +texts.say("front.none") }
        classChart(texts, exercise, places, own = null) { point, _ ->
            a("/submissions/${point.submission}") { +point.name }
        }
    }
}

/** The most names that stand beside the plot, and how many characters of each. */
private const val LABELS = 12
private const val LABEL = 24

/**
 * The chart, and its table.
 *
 * @param own id of the student whose place is marked; null for none
 * @param named tells in the table whose place it is, and whether it is the own one
 */
private fun FlowContent.classChart(
    texts: PageTexts,
    exercise: Exercise,
    places: List<FrontPoint>,
    own: String?,
    named: TD.(FrontPoint, Boolean) -> Unit,
) {
    if (places.isEmpty()) return
    val topic = Topics.named(exercise.topic())
    val few = places.count { it.named } <= LABELS
    val points =
        places.map {
            val mine = it.student == own
            val shown = own != null && few && it.named && !mine
            val name = if (shown) it.name.take(LABEL) else texts.say("chart.own")
            ChartPoint(name, it.ratio, it.error, own = mine, labelled = mine || shown)
        }
    val scale = ChartScale(topic.item(), topic.errorUnit(), SpeedPoints.fullUpTo())
    val drawn = SpeedDrawing(texts, scale, points) { texts.say("front.words", points.size) }
    section("speed") {
        figure("chart") {
            unsafe { +drawn.svg() }
            figcaption { +texts.say("front.caption", drawn.number(scale.fullUpTo)) }
        }
        details {
            summary { +texts.say("chart.table") }
            scrolling(texts.say("chart.table")) {
                table {
                    thead {
                        tr {
                            th(scope = ThScope.col) { +texts.say("table.student") }
                            th(scope = ThScope.col, classes = "number") { +texts.say("chart.ratio") }
                            th(scope = ThScope.col, classes = "number") { +drawn.errorAxis }
                        }
                    }
                    tbody {
                        places.zip(points).forEach { (place, point) ->
                            tr {
                                td { named(place, point.own) }
                                td("number") { +drawn.ratio(point) }
                                td("number") { +drawn.error(point) }
                            }
                        }
                    }
                }
            }
        }
    }
}
