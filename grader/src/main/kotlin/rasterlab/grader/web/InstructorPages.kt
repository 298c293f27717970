package rasterlab.grader.web

import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.button
import kotlinx.html.code
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.id
import kotlinx.html.li
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.stream.createHTML
import kotlinx.html.ul
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.report.onEachChange
import rasterlab.grader.report.respondEvents
import rasterlab.grader.submission.Live
import rasterlab.grader.submission.Submissions

/** Courses, and what students hand in, as it comes. */
fun Route.instructorPages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    submissions: Submissions,
    live: Live,
) {
    get("/instructor") { call.respondDesk(call.instructorHere(accounts), courses.all(), exercises, submissions) }
    get("/instructor/latest") {
        call.instructorHere(accounts)
        val texts = call.texts()
        call.respondFragment(createHTML(prettyPrint = false).div { latest(texts, exercises, submissions) })
    }
    get("/instructor/events") {
        call.instructorHere(accounts)
        call.respondEvents {
            onEachChange(live, submission = null) {
                send("{}", event = "changed")
                true
            }
        }
    }
    post("/instructor/courses") {
        call.requireOwnForm()
        val instructor = call.instructorHere(accounts)
        courses.create(instructor, Name.of(call.receiveForm()["name"].orEmpty()), key = null)
        call.respondRedirect("/instructor")
    }
}

private suspend fun ApplicationCall.respondDesk(
    who: Identity.Instructor,
    courses: List<Course>,
    exercises: Exercises,
    submissions: Submissions,
) {
    val texts = texts()
    respondPage(texts, who, texts.say("instructor.title")) {
        div("columns") {
            section("card") {
                h2 { +texts.say("instructor.courses") }
                courseList(texts, courses)
            }
            section("card") {
                h2 { +texts.say("instructor.create") }
                form("/instructor/courses", method = FormMethod.post) {
                    field(texts.say("instructor.course.name"), "name")
                    button { +texts.say("instructor.create.do") }
                }
            }
        }
        h2 { +texts.say("instructor.latest") }
        div {
            id = "live"
            attributes["data-events"] = "/instructor/events"
            attributes["data-fragment"] = "/instructor/latest"
            latest(texts, exercises, submissions)
        }
    }
}

private fun FlowContent.courseList(
    texts: Texts,
    courses: List<Course>,
) {
    if (courses.isEmpty()) p { +texts.say("instructor.none") }
    ul("courses") {
        courses.forEach { course ->
            li {
                span("title") { +course.name }
                span {
                    +"${texts.say("instructor.code")}: "
                    code("code") { +course.code }
                }
            }
        }
    }
}

private fun FlowContent.latest(
    texts: Texts,
    exercises: Exercises,
    submissions: Submissions,
) {
    val rows = submissions.latest()
    if (rows.isEmpty()) p { +texts.say("instructor.latest.none") }
    if (rows.isNotEmpty()) classTable(texts, rows) { exercises.find(it)?.title(texts.language) ?: it }
}
