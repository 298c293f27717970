package rasterlab.grader.web.classroom

import io.ktor.server.application.ApplicationCall
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.TD
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.details
import kotlinx.html.figcaption
import kotlinx.html.figure
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
        call.respondOwnPlace(student, exercise, places)
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
) {
    val texts = texts()
    respondPage(texts, student, "${texts.say("front.heading")}: ${exercise.title(texts.language)}") {
        p { a("/exercises/${exercise.id()}") { +texts.say("front.back") } }
        p("plan") { +texts.say("front.anonymous") }
        if (places.size < ClassFront.LEAST) p { +texts.say("front.few", ClassFront.LEAST) }
        classChart(texts, exercise, places, student.id) { _, own ->
            +texts.say(if (own) "chart.own" else "front.other")
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
    val points =
        places.map {
            val mine = it.student == own
            ChartPoint(texts.say("chart.own"), it.ratio, it.error, own = mine, labelled = mine)
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
