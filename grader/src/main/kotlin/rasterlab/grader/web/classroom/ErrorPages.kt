/*
 * Pages on which staff see a class as a whole.
 * Read ErrorPages; what they show comes from the package classroom.
 */
package rasterlab.grader.web.classroom

import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.TR
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.id
import kotlinx.html.img
import kotlinx.html.label
import kotlinx.html.li
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.summary
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.textArea
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import kotlinx.html.ul
import rasterlab.exercises.Exercise
import rasterlab.exercises.score.Disclosure
import rasterlab.grader.classroom.CaseMark
import rasterlab.grader.classroom.ErrorMap
import rasterlab.grader.classroom.GroupComment
import rasterlab.grader.classroom.GroupComments
import rasterlab.grader.classroom.LastResult
import rasterlab.grader.classroom.LastResults
import rasterlab.grader.classroom.MappedCase
import rasterlab.grader.classroom.WrongGroup
import rasterlab.grader.classroom.differencesAddress
import rasterlab.grader.classroom.from
import rasterlab.grader.classroom.group
import rasterlab.grader.classroom.sum
import rasterlab.grader.comment.CommentText
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.comment.COMMENT_BYTES
import rasterlab.grader.web.courseOf
import rasterlab.grader.web.exerciseOf
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.rulesAddress
import rasterlab.grader.web.scrolling
import rasterlab.grader.web.sign
import rasterlab.grader.web.staffHere
import rasterlab.grader.web.status
import rasterlab.grader.web.texts

/** Shows staff which cases of an exercise fail, and for whom. */
fun Route.errorPages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    last: LastResults,
    comments: GroupComments,
) {
    get("/instructor/courses/{course}/exercises/{id}/errors") {
        val who = call.staffHere(accounts)
        val course = call.courseOf(courses)
        val exercise = call.exerciseOf(exercises)
        val map = ErrorMap(last.of(course.id, exercise.id()), exercise)
        call.respondErrors(who, course, exercise, map, comments.of(course, exercise))
    }
    post("/instructor/courses/{course}/exercises/{id}/errors/groups/{group}/comment") {
        call.requireOwnForm()
        val who = call.staffHere(accounts)
        val course = call.courseOf(courses)
        val exercise = call.exerciseOf(exercises)
        val text = call.receiveForm(COMMENT_BYTES)["text"].orEmpty()
        if (text.isBlank()) {
            comments.drop(who, course, exercise, call.group())
        } else {
            comments.write(who, course, exercise, call.group(), CommentText.of(text))
        }
        call.respondRedirect("${errorsAddress(course, exercise)}#group-${call.group()}")
    }
    get("/instructor/courses/{course}/exercises/{id}/errors/{case}") {
        val who = call.staffHere(accounts)
        val course = call.courseOf(courses)
        val exercise = call.exerciseOf(exercises)
        val name = call.parameters.getOrFail("case")
        val map = ErrorMap(last.of(course.id, exercise.id()), exercise)
        val case = map.cases.find { it.name == name } ?: throw Rejection.UnknownScene(name)
        call.respondCase(who, course, exercise, map, case, last)
    }
}

/** A coordinate with a minus as people write it. */
private fun coordinate(value: Int) = "$value".replace('-', '−')

internal fun errorsAddress(
    course: Course,
    exercise: Exercise,
) = "${rulesAddress(course, exercise)}/errors"

private suspend fun ApplicationCall.respondErrors(
    who: Identity.StaffIdentity,
    course: Course,
    exercise: Exercise,
    map: ErrorMap,
    comments: Map<String, GroupComment>,
) {
    val texts = texts()
    val from = from()
    val heading = "${texts.say("errors.heading")}: ${exercise.title(texts.language)} — ${course.name}"
    respondPage(texts, who, heading) {
        waysOfClass(texts, course, exercise, "errors")
        p("plan") { +texts.say("errors.about") }
        if (map.results.isEmpty()) p { +texts.say("errors.none") }
        if (map.cases.isNotEmpty()) {
            p { +texts.say("errors.count", map.results.size, map.cases.count { it.nobodyPasses }) }
            h2 { +texts.say("errors.cases") }
            caseTable(texts, course, exercise, map)
            studentTable(texts, course, exercise, map, from)
        }
        if (map.withoutCases.isNotEmpty()) {
            h2 { +texts.say("errors.without") }
            ul { map.withoutCases.forEach { li { work(texts, it) } } }
        }
        if (exercise.form() == Exercise.TaskKind.WRITE && map.cases.isNotEmpty()) {
            groups(texts, course, exercise, map.groups, comments)
        }
    }
}

private fun FlowContent.work(
    texts: PageTexts,
    one: LastResult,
) {
    a("/submissions/${one.submission}") { +one.name }
    +" "
    status(texts, one.verdict, "")
}

private fun FlowContent.caseTable(
    texts: PageTexts,
    course: Course,
    exercise: Exercise,
    map: ErrorMap,
) = scrolling(texts.say("errors.cases")) {
    table("error-cases") {
        thead {
            tr {
                th(scope = ThScope.col) { +texts.say("errors.case") }
                listOf("failed", "passed", "notRun").forEach {
                    th(scope = ThScope.col, classes = "number") { +texts.say("errors.$it") }
                }
            }
        }
        tbody {
            map.cases.forEach { case ->
                tr {
                    td {
                        a("${errorsAddress(course, exercise)}/${case.name}") {
                            +exercise.caseTitle(case.name, texts.language)
                        }
                        if (case.visibility != Disclosure.OPEN) span("earlier") { +texts.say("result.hidden") }
                        if (case.nobodyPasses) span("loses") { +texts.say("errors.nobody") }
                    }
                    listOf(case.failed, case.passed, case.notRun).forEach { td("number") { +"$it" } }
                }
            }
        }
    }
}

/** Cases against students, as many of these as stand beside each other on one page. */
private fun FlowContent.studentTable(
    texts: PageTexts,
    course: Course,
    exercise: Exercise,
    map: ErrorMap,
    from: Int,
) {
    val judged = map.results.filter { it.cases.isNotEmpty() }
    val shown = judged.drop(from).take(COLUMNS)
    h2 { +texts.say("errors.students") }
    if (shown.isEmpty()) {
        p { +texts.say("errors.students.none") }
    } else {
        p { +texts.say("errors.shown", from + 1, from + shown.size, judged.size) }
        val marks = shown.map { one -> one.cases.associateBy { it.name } }
        scrolling(texts.say("errors.students")) {
            table("error-map") {
                thead {
                    tr {
                        th(scope = ThScope.col) { +texts.say("errors.case") }
                        shown.forEach { one ->
                            th(scope = ThScope.col) { a("/submissions/${one.submission}") { +one.name } }
                        }
                    }
                }
                tbody {
                    map.cases.forEach { case ->
                        tr {
                            th(scope = ThScope.row) { +exercise.caseTitle(case.name, texts.language) }
                            marks.forEach { mark(texts, it[case.name]) }
                        }
                    }
                }
            }
        }
    }
    p("ways") {
        val address = errorsAddress(course, exercise)
        if (from > 0) a("$address?from=${maxOf(0, from - COLUMNS)}") { +texts.say("errors.earlier") }
        if (from.toLong() + COLUMNS < judged.size) a("$address?from=${from + COLUMNS}") { +texts.say("errors.later") }
    }
}

/** A sign for eyes, and the word for whoever is read to. */
private fun TR.mark(
    texts: PageTexts,
    mark: CaseMark?,
) = td {
    if (mark == null) {
        +"–"
    } else {
        val verdict = mark.verdict.code()
        span("status $verdict") {
            span("sign") {
                attributes["aria-hidden"] = "true"
                +sign(verdict)
            }
            span("unseen") { +texts.verdict(verdict) }
        }
    }
}

private fun FlowContent.groups(
    texts: PageTexts,
    course: Course,
    exercise: Exercise,
    groups: List<WrongGroup>,
    comments: Map<String, GroupComment>,
) {
    h2 { +texts.say("errors.groups") }
    p("plan") { +texts.say("errors.groups.about") }
    if (groups.isEmpty()) p { +texts.say("errors.groups.none") }
    groups.forEach { group ->
        section("card apart") {
            id = "group-${group.id}"
            p("title") {
                val named = group.mistake.`in`(texts.language)
                +texts.say("errors.group", group.members.size)
                if (named.isNotEmpty()) +": $named"
            }
            p {
                group.members.forEachIndexed { number, one ->
                    if (number > 0) +", "
                    a("/submissions/${one.submission}") { +one.name }
                }
            }
            details {
                summary { +texts.say("errors.group.cases", group.cases.size) }
                ul { group.cases.forEach { li { +exercise.caseTitle(it, texts.language) } } }
            }
            comment(texts, course, exercise, group.id, comments[group.id])
        }
    }
    val others = comments.values.filter { said -> groups.none { it.id == said.group } }
    if (others.isNotEmpty()) h2 { +texts.say("group.others") }
    others.forEach {
        section("card apart") {
            id = "group-${it.group}"
            comment(texts, course, exercise, it.group, it)
        }
    }
}

/** Shows what is said to a group, and the form that changes it. */
private fun FlowContent.comment(
    texts: PageTexts,
    course: Course,
    exercise: Exercise,
    group: String,
    said: GroupComment?,
) {
    if (said != null) {
        div("said") {
            p("by") { +"${said.name} ${texts.say("comment.at", texts.time(said.writtenAt))}".trim() }
            p("words") { +said.text }
        }
    }
    details {
        summary { +texts.say(if (said == null) "group.write" else "group.change") }
        form("${errorsAddress(course, exercise)}/groups/$group/comment", method = FormMethod.post) {
            label {
                htmlFor = "text-$group"
                +texts.say("group.text")
            }
            textArea {
                id = "text-$group"
                name = "text"
                rows = "4"
                attributes["maxlength"] = "${CommentText.MOST}"
                +said?.text.orEmpty()
            }
            button { +texts.say("group.save") }
        }
    }
}

private suspend fun ApplicationCall.respondCase(
    who: Identity.StaffIdentity,
    course: Course,
    exercise: Exercise,
    map: ErrorMap,
    case: MappedCase,
    last: LastResults,
) {
    val texts = texts()
    val sum = if (case.summed) last.sum(course, exercise, case.name) else null
    respondPage(texts, who, exercise.caseTitle(case.name, texts.language)) {
        p { a(errorsAddress(course, exercise)) { +texts.say("errors.back") } }
        if (case.nobodyPasses) p("loses") { +texts.say("errors.nobody") }
        if (sum != null) {
            h2 { +texts.say("errors.sum") }
            p("legend") { +texts.say("errors.sum.legend") }
            val worst =
                sum.inWords { x, y, missing, extra ->
                    texts.say("errors.sum.worst", coordinate(x), coordinate(y), missing, extra)
                }
            img(
                src = differencesAddress(course, exercise, case.name),
                alt = "${texts.say("errors.sum")}. $worst",
                classes = "sum",
            )
            p { +worst }
        }
        val marks =
            map.results.mapNotNull { one -> one.cases.find { it.name == case.name }?.let { one to it } }
        val (passed, failed) = marks.partition { (_, mark) -> mark.passed }
        listOf("failed" to failed, "passed" to passed).filter { it.second.isNotEmpty() }.forEach { (kind, those) ->
            h2 { +"${texts.say("errors.$kind")}: ${those.size}" }
            ul {
                those.forEach { (one, mark) ->
                    li {
                        a("/submissions/${one.submission}") { +one.name }
                        +" "
                        status(texts, mark.verdict.code(), "")
                    }
                }
            }
        }
    }
}

/** Students beside each other on one page. */
private const val COLUMNS = 25
