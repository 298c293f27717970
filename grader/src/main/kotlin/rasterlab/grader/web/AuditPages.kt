package rasterlab.grader.web

import io.ktor.server.application.ApplicationCall
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import kotlinx.html.FlowContent
import kotlinx.html.a
import kotlinx.html.p
import kotlinx.html.span
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Audit
import rasterlab.grader.course.AuditEntry
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.ListPart
import rasterlab.grader.problem.Paging

/** Shows an instructor what staff changed, the latest first, a page at a time. */
fun Route.auditPages(
    accounts: Accounts,
    audit: Audit,
    exercises: Exercises,
) = get("/instructor/audit") {
    val who = call.instructorHere(accounts)
    val before = call.request.queryParameters["before"]
    call.respondAudit(who, audit.part(Paging(before)), exercises, begins = before == null)
}

private suspend fun ApplicationCall.respondAudit(
    who: Identity.Instructor,
    part: ListPart<AuditEntry>,
    exercises: Exercises,
    begins: Boolean,
) {
    val texts = texts()
    respondPage(texts, who, texts.say("audit.title")) {
        p { a("/instructor") { +texts.say("token.back") } }
        p("plan") { +texts.say("audit.about", texts.zoneName) }
        if (part.items.isEmpty()) p { +texts.say("audit.none") } else changeTable(texts, part.items, exercises)
        p("ways") {
            if (!begins) a("/instructor/audit") { +texts.say("audit.latest") }
            part.next?.let { a("/instructor/audit?before=$it") { +texts.say("audit.earlier") } }
        }
    }
}

private fun FlowContent.changeTable(
    texts: PageTexts,
    entries: List<AuditEntry>,
    exercises: Exercises,
) {
    val columns: List<Pair<String, FlowContent.(AuditEntry) -> Unit>> =
        listOf(
            "when" to { moment(texts, it.notedAt) },
            "who" to { +texts.doer(it) },
            "what" to { +texts.action(it.action) },
            "subject" to { subject(texts, it, exercises) },
            "course" to { +(it.course ?: "–") },
            "detail" to { +(if (it.detail == it.subjectName) "–" else texts.detail(it, exercises).ifEmpty { "–" }) },
        )
    stacked(
        texts.say("audit.title"),
        columns.map { (name, content) -> texts.say("audit.column.$name") to content },
        entries,
    )
}

private fun FlowContent.subject(
    texts: PageTexts,
    one: AuditEntry,
    exercises: Exercises,
) {
    val named = one.subjectName ?: one.subject
    val name = if (isOfExercise(one)) texts.exercise(named, exercises) else named
    val before = extended(one)?.let { texts.exercise(it, exercises) + ", " }.orEmpty()
    when {
        one.deletedNumber != null -> gone(one, before + texts.say("audit.deleted", "${one.deletedNumber}"))
        one.subjectName == null && isOfSubmission(one) -> gone(one, texts.say("audit.deleted.submission"))
        one.subjectName == null -> +name.ifEmpty { "–" }
        isOfSubmission(one) -> a("/submissions/${one.subject}") { +name }
        one.action.startsWith("regrade") -> a("/instructor/regrades/${one.subject}") { +name }
        else -> +(before + name)
    }
}

private fun isOfExercise(one: AuditEntry) =
    one.action.startsWith("regrade") || one.action in setOf("rules", "comment-group", "comment-group-drop")

/** The id of the exercise of an extension, which stands before the student whose it is; null for all other changes. */
private fun extended(one: AuditEntry): String? =
    if (one.action == "extension") one.subject.substringBeforeLast(' ') else null

/** Says what was deleted; its id, which names nobody any more, is a hint. */
private fun FlowContent.gone(
    one: AuditEntry,
    words: String,
) = span {
    attributes["title"] = one.subject
    +words
}

private val OF_SUBMISSIONS =
    setOf("points", "points-revoke", "complaint-accept", "complaint-decline", "comment") +
        listOf("answer", "edit", "delete", "settle").map { "comment-$it" }

private fun isOfSubmission(one: AuditEntry) = one.action in OF_SUBMISSIONS

private fun PageTexts.doer(one: AuditEntry): String =
    when {
        one.action == "lti-name" -> say("audit.platform")
        one.role.isEmpty() -> say("audit.command")
        one.byName.isEmpty() -> say("staff.unnamed")
        else -> one.byName
    }
