package rasterlab.grader.web

import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import kotlinx.html.FlowContent
import kotlinx.html.FormEncType
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.LI
import kotlinx.html.TBODY
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.code
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.li
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import kotlinx.html.ul
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Enrolled
import rasterlab.grader.course.Identity
import rasterlab.grader.course.ROSTER_BYTES
import rasterlab.grader.course.RosterChange
import rasterlab.grader.course.RosterCorrection
import rasterlab.grader.course.RosterImport
import rasterlab.grader.problem.Rejection
import rasterlab.grader.report.Grades
import rasterlab.grader.report.GradesReader
import rasterlab.grader.report.respondGrades
import rasterlab.grader.storage.Secrets
import rasterlab.grader.submission.FormField
import rasterlab.grader.submission.Marks
import rasterlab.grader.submission.Submissions
import rasterlab.grader.submission.receiveFields
import rasterlab.grader.web.comment.ONCE
import java.util.Base64

/** The field of the file that is sent, and that of the same file once more when its changes were seen. */
private const val FILE = "roster"
private const val SEEN = "seen"

private class RosterTooLarge : Rejection.TooLarge(ROSTER_BYTES) {
    override val pageText get() = "$code.roster"
}

/** Shows staff who is in a course, and takes rosters from instructors: it tells what would change, and then changes it. */
fun Route.rosterPages(
    accounts: Accounts,
    courses: Courses,
    roster: RosterImport,
    submissions: Submissions,
    marks: Marks,
) {
    get("/instructor/courses/{course}/students") {
        val who = call.staffHere(accounts)
        RosterDesk(call.courseOf(courses), courses, submissions, marks).show(call, who, refused = null)
    }
    post("/instructor/courses/{course}/students") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val desk = RosterDesk(call.courseOf(courses), courses, submissions, marks)
        desk.showAgain(call, who)
        val fields = call.receiveFields(2 * ROSTER_BYTES, ::RosterTooLarge)
        val seen = fields.content(SEEN)?.let(::unpacked)
        val file = seen ?: fields.content(FILE) ?: throw Rejection.BadRoster("empty")
        if (file.size > ROSTER_BYTES) throw RosterTooLarge()
        val once = fields.content(ONCE)?.decodeToString()
        val change = roster.apply(desk.course, file, dry = seen == null, who.id, once)
        if (seen == null) desk.preview(call, who, file, change) else desk.done(call, who, change)
    }
}

/** Gives instructors the marks of a course as a file. */
fun Route.gradesPages(
    accounts: Accounts,
    grades: Grades,
) = get("/instructor/courses/{course}/grades.csv") {
    call.instructorHere(accounts)
    call.respondGrades(grades)
}

private fun List<FormField>.content(name: String): ByteArray? =
    firstOrNull { it.name == name }?.content?.takeIf { it.isNotEmpty() }

private fun unpacked(seen: ByteArray): ByteArray =
    try {
        Base64.getDecoder().decode(seen)
    } catch (invalid: IllegalArgumentException) {
        throw Rejection.Malformed("the form's field '$SEEN' must be the one that the page has")
    }

/** The page of a course's students. */
private class RosterDesk(
    val course: Course,
    private val courses: Courses,
    private val submissions: Submissions,
    private val marks: Marks,
) {
    private val address = "/instructor/courses/${course.id}/students"

    fun showAgain(
        call: ApplicationCall,
        who: Identity.Instructor,
    ) = call.attributes.put(
        FORM_AGAIN,
        FormAgain { status, code, added ->
            show(call, who, Refused(status, code, added(call.texts().language)))
        },
    )

    suspend fun show(
        call: ApplicationCall,
        who: Identity.StaffIdentity,
        refused: Refused?,
    ) {
        val texts = call.texts()
        val students = courses.students(course.id).orEmpty()
        val made = submissions.countsOf(course.id)
        val points = marks.of(course.id).mapValues { it.value.values.sum() }
        call.respondPage(texts, who, texts.say("roster.title", course.name), refused?.status ?: HttpStatusCode.OK) {
            refused?.let { problem(texts, it.status, it.code, it.details) }
            p { a("/instructor") { +texts.say("token.back") } }
            val mayChange = who is Identity.Instructor
            if (students.isEmpty()) p { +texts.say("roster.none", course.code) }
            if (students.isNotEmpty()) studentTable(texts, students, made, points, mayChange)
            if (mayChange && students.isNotEmpty()) marks(texts)
            if (mayChange) upload(texts)
        }
    }

    private fun FlowContent.marks(texts: PageTexts) =
        section("card rostered") {
            h2 { +texts.say("grades.title") }
            p { +texts.say("grades.about") }
            p("ways") {
                for (reader in GradesReader.entries) {
                    a("/instructor/courses/${course.id}/grades.csv?for=${reader.code}") {
                        +texts.say("grades.${reader.code}")
                    }
                }
            }
        }

    private fun FlowContent.upload(texts: PageTexts) =
        section("card rostered") {
            h2 { +texts.say("roster.upload") }
            p { +texts.say("roster.about") }
            form(address, method = FormMethod.post, encType = FormEncType.multipartFormData) {
                label {
                    span { +texts.say("roster.file") }
                    input(InputType.file, name = FILE) {
                        accept = ".csv,.txt,text/csv,text/plain"
                        required = true
                    }
                }
                button { +texts.say("roster.preview") }
            }
        }

    suspend fun preview(
        call: ApplicationCall,
        who: Identity.Instructor,
        file: ByteArray,
        change: RosterChange,
    ) {
        val texts = call.texts()
        call.respondPage(texts, who, texts.say("roster.changes.title", course.name)) {
            p { +texts.say("roster.preview.about") }
            changes(texts, change, "roster.corrected")
            section("card rostered") {
                if (change.added.isEmpty() && change.corrected.isEmpty()) {
                    p { +texts.say("roster.nothing") }
                } else {
                    form(address, method = FormMethod.post, encType = FormEncType.multipartFormData) {
                        input(InputType.hidden, name = SEEN) { value = Base64.getEncoder().encodeToString(file) }
                        input(InputType.hidden, name = ONCE) { value = Secrets.newId() }
                        button { +texts.say("roster.apply") }
                    }
                }
                p { a(address) { +texts.say("roster.back") } }
            }
        }
    }

    suspend fun done(
        call: ApplicationCall,
        who: Identity.Instructor,
        change: RosterChange,
    ) {
        val texts = call.texts()
        call.respondPage(texts, who, texts.say("roster.done.title", course.name)) {
            if (change.added.isNotEmpty()) {
                p { +texts.say("roster.tokens") }
                rows(listOf(texts.say("table.student"), texts.say("roster.token"))) {
                    change.added.forEach { one ->
                        tr {
                            td { +one.name }
                            td {
                                code("token") { +one.token.orEmpty() }
                                one.token?.let { signInLink(texts, it) }
                            }
                        }
                    }
                }
            }
            changes(texts, change.copy(added = emptyList()), "roster.corrected.done")
            p { a(address, classes = "button") { +texts.say("roster.back") } }
        }
    }
}

private fun FlowContent.studentTable(
    texts: PageTexts,
    students: List<Enrolled>,
    made: Map<String, Int>,
    points: Map<String, Int>,
    mayChange: Boolean,
) {
    fun said(vararg columns: String) = columns.map { texts.say("roster.column.$it") }
    val numbers = said("number", "attempts", "points").toSet()
    val columns = listOfNotNull("number", "student", "attempts", "points", "entry".takeIf { mayChange })
    val (attempts, earned) = said("attempts", "points")
    rows(said(*columns.toTypedArray()), numbers, "enrolled") {
        students.forEach { student ->
            tr {
                td("number") { +"${student.number}" }
                td { a("/instructor/students/${student.id}") { +student.shownName } }
                td("number") {
                    column(attempts)
                    +"${made[student.id] ?: 0}"
                }
                td("number") {
                    column(earned)
                    +(points[student.id]?.toString() ?: "–")
                }
                if (mayChange) {
                    td { newTokenButton(texts, "/instructor/students/${student.id}/token", student.shownName) }
                }
            }
        }
    }
}

private fun FlowContent.rows(
    columns: List<String>,
    numbers: Set<String> = emptySet(),
    kind: String = "",
    content: TBODY.() -> Unit,
) = div("scroll") {
    table("students $kind".trim()) {
        thead {
            tr {
                columns.forEach { column ->
                    th(scope = ThScope.col, classes = if (column in numbers) "number" else null) { +column }
                }
            }
        }
        tbody { content() }
    }
}

/**
 * Tells what a roster changes, a list for each kind of change.
 *
 * @param corrected names the heading of those who are, or were, corrected
 */
private fun FlowContent.changes(
    texts: PageTexts,
    change: RosterChange,
    corrected: String,
) {
    list(texts.say("roster.added", change.added.size), change.added.map { it.name })
    if (change.corrected.isNotEmpty()) {
        h2 { +texts.say(corrected, change.corrected.size) }
        ul { change.corrected.forEach { li { correction(texts, it) } } }
    }
    list(texts.say("roster.missing", change.missing.size), change.missing.map { it.shownName })
    if (change.unchanged > 0) p { +texts.say("roster.unchanged", change.unchanged) }
    if (change.unused.isNotEmpty()) p { +texts.say("roster.unused", change.unused.joinToString()) }
}

private fun LI.correction(
    texts: PageTexts,
    one: RosterCorrection,
) {
    +one.from
    ul {
        if (one.from != one.to) li { +texts.say("roster.change", texts.say("roster.field.name"), one.from, one.to) }
        one.changes.forEach { (field, from, to) ->
            val name = texts.say("roster.field.$field")
            li { +(from?.let { texts.say("roster.change", name, it, to) } ?: texts.say("roster.change.new", name, to)) }
        }
    }
}

private fun FlowContent.list(
    heading: String,
    lines: List<String>,
) {
    if (lines.isEmpty()) return
    h2 { +heading }
    ul { lines.forEach { li { +it } } }
}
