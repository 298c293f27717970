package rasterlab.grader.web

import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.code
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.id
import kotlinx.html.li
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.stream.createHTML
import kotlinx.html.summary
import kotlinx.html.ul
import rasterlab.exercises.Exercise
import rasterlab.exercises.runner.Isolation
import rasterlab.grader.comment.Comments
import rasterlab.grader.complaint.ComplaintDesk
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Enrolled
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.hint.HintUse
import rasterlab.grader.hint.Hints
import rasterlab.grader.problem.Rejection
import rasterlab.grader.report.onEachChange
import rasterlab.grader.report.respondEvents
import rasterlab.grader.submission.Listed
import rasterlab.grader.submission.Live
import rasterlab.grader.submission.Submissions

/** Courses, and what students hand in, as it comes. */
fun Route.instructorPages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    submissions: Submissions,
    comments: Comments,
    complaints: ComplaintDesk,
    hints: Hints,
    live: Live,
    isolation: () -> Isolation,
) {
    get("/instructor") {
        val who = call.staffHere(accounts)
        val waiting = Waiting(comments.openCounts(), complaints.openCounts())
        call.respondDesk(who, courses, exercises, submissions, waiting, hints.latest(who), isolation())
    }
    get("/instructor/latest") {
        val who = call.staffHere(accounts)
        val texts = call.texts()
        call.respondFragment(createHTML(prettyPrint = false).div { latest(texts, exercises, submissions.latest(who)) })
    }
    get("/instructor/events") {
        call.staffHere(accounts)
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
        courses.create(instructor.id, Name.of(call.receiveForm()["name"].orEmpty()), key = null)
        call.respondRedirect("/instructor")
    }
    post("/instructor/students/{student}/token") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val student = call.parameters.getOrFail("student")
        val token = accounts.renewStudent(student, who.id, key = null) ?: throw Rejection.UnknownStudent(student)
        val holder = accounts.holder(token) as? Identity.StudentIdentity
        call.respondToken(who, holder?.name.orEmpty(), token, "/instructor", "token.back")
    }
    post("/instructor/students/{student}/revoke") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val student = call.parameters.getOrFail("student")
        accounts.revokeStudent(student, who.id)
        call.respondRedirect("/instructor/students/$student")
    }
}

/**
 * Answers with a new token, this once.
 *
 * @param back text of the link that leads on to the page [to]
 */
internal suspend fun ApplicationCall.respondToken(
    who: Identity.Instructor,
    name: String,
    token: String,
    to: String,
    back: String,
) {
    val texts = texts()
    respondPage(texts, who, texts.say("token.title", name)) {
        section("card") {
            p { +texts.say("token.keep") }
            p {
                code("token") { +token }
                signInLink(texts, token)
            }
            p { a(to, classes = "button") { +texts.say(back) } }
        }
    }
}

private suspend fun ApplicationCall.respondDesk(
    who: Identity.StaffIdentity,
    courses: Courses,
    exercises: Exercises,
    submissions: Submissions,
    waiting: Waiting,
    hints: List<HintUse>,
    isolation: Isolation,
) {
    val texts = texts()
    val students = courses.of(who).associateWith { courses.students(it.id).orEmpty() }
    val mayChange = who is Identity.Instructor
    val leads = mayChange && who.onlyCourse == null
    respondPage(texts, who, texts.say(if (mayChange) "instructor.title" else "assistant.title")) {
        div("columns") {
            section("card") {
                h2 { +texts.say("instructor.courses") }
                courseList(texts, students, waiting, mayChange, leads)
            }
            if (leads) {
                creation(texts)
                section("card") {
                    h2 { +texts.say("staff.title") }
                    p { +texts.say("staff.about") }
                    p("ways") {
                        a("/instructor/staff") { +texts.say("staff.open") }
                        a("/instructor/audit") { +texts.say("audit.open") }
                        a("/instructor/lti") { +texts.say("lti.title") }
                    }
                }
            }
            section("card") {
                h2 { +texts.say("instructor.isolation") }
                p { +isolation.describe(texts.language) }
                if (leads) p("ways") { a("/instructor/workers") { +texts.say("worker.open") } }
            }
        }
        h2 { +texts.say("instructor.latest") }
        div {
            id = "live"
            attributes["data-events"] = "/instructor/events"
            attributes["data-fragment"] = "/instructor/latest"
            latest(texts, exercises, submissions.latest(who))
        }
        if (who.onlyCourse == null) {
            h2 { +texts.say("similarity.heading") }
            similarLinks(texts, exercises)
        }
        h2 { +texts.say("instructor.hints") }
        if (hints.isEmpty()) p { +texts.say("instructor.hints.none") } else hintTable(texts, exercises, hints)
    }
}

private fun FlowContent.creation(texts: PageTexts) =
    section("card") {
        h2 { +texts.say("instructor.create") }
        form("/instructor/courses", method = FormMethod.post) {
            field(texts.say("instructor.course.name"), "name")
            button { +texts.say("instructor.create.do") }
        }
    }

/** How much waits for an answer, by the course's id. */
private class Waiting(
    val questions: Map<String, Int>,
    val complaints: Map<String, Int>,
)

/**
 * @param mayChange whether who looks may change these courses, and not only see them
 * @param leads whether they may make others, too
 */
private fun FlowContent.courseList(
    texts: PageTexts,
    courses: Map<Course, List<Enrolled>>,
    waiting: Waiting,
    mayChange: Boolean,
    leads: Boolean,
) {
    if (courses.isEmpty()) p { +texts.say(if (mayChange) "instructor.none" else "assistant.none") }
    ul("courses") {
        courses.forEach { (course, students) ->
            li {
                span("title") { +course.name }
                span {
                    +"${texts.say("instructor.code")}: "
                    code("code") { +course.code }
                }
                p("ways") {
                    a("/instructor/courses/${course.id}/students") { +texts.say("instructor.roster") }
                    a("/instructor/courses/${course.id}/exercises") { +texts.say("instructor.rules") }
                    a("/instructor/courses/${course.id}/questions") {
                        +texts.say("instructor.questions", waiting.questions[course.id] ?: 0)
                    }
                    a("/instructor/courses/${course.id}/complaints") {
                        +texts.say("instructor.complaints", waiting.complaints[course.id] ?: 0)
                    }
                    a("/instructor/courses/${course.id}/exams") { +texts.say("exams.open") }
                    a("/instructor/courses/${course.id}/lti") { +texts.say("lti.open") }
                    if (leads) a("/instructor/courses/${course.id}/clone") { +texts.say("instructor.clone") }
                }
                details {
                    summary { +texts.say("instructor.students", students.size) }
                    studentList(texts, students, mayChange)
                }
            }
        }
    }
}

private fun FlowContent.studentList(
    texts: PageTexts,
    students: List<Enrolled>,
    mayChange: Boolean,
) = ul {
    students.forEach { student ->
        li {
            +"${student.shownName} "
            if (mayChange) newTokenButton(texts, "/instructor/students/${student.id}/token", student.shownName)
        }
    }
}

/** A form of one button, which makes a new token for [name]. */
internal fun FlowContent.newTokenButton(
    texts: PageTexts,
    address: String,
    name: String,
) = form(address, method = FormMethod.post) {
    button(classes = "plain") {
        attributes["aria-label"] = "${texts.say("instructor.token")}: $name"
        +texts.say("instructor.token")
    }
}

private fun FlowContent.latest(
    texts: PageTexts,
    exercises: Exercises,
    rows: List<Listed>,
) {
    if (rows.isEmpty()) p { +texts.say("instructor.latest.none") }
    if (rows.isNotEmpty()) classTable(texts, exercises, rows)
}

/** Links to the lists of pairs, for each exercise that programs are written for. */
private fun FlowContent.similarLinks(
    texts: PageTexts,
    exercises: Exercises,
) = details {
    summary { +texts.say("similar.choose") }
    ul {
        exercises.all.filter { it.form() == Exercise.TaskKind.WRITE }.forEach {
            li { a("/instructor/exercises/${it.id()}/similarity") { +it.title(texts.language) } }
        }
    }
}
