// Complaints below the cases that they are about, and the page of a course's complaints. Start with CaseComplaints.
package rasterlab.grader.web.complaint

import io.ktor.http.Parameters
import kotlinx.html.FORM
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.id
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.p
import kotlinx.html.span
import kotlinx.html.strong
import kotlinx.html.summary
import rasterlab.exercises.published.PublishedCase
import rasterlab.exercises.score.CaseReport
import rasterlab.grader.complaint.CaseComplaint
import rasterlab.grader.complaint.ComplaintAnswer
import rasterlab.grader.complaint.ComplaintDesk
import rasterlab.grader.complaint.ComplaintState
import rasterlab.grader.complaint.canBeComplainedOf
import rasterlab.grader.course.Identity
import rasterlab.grader.storage.Secrets
import rasterlab.grader.submission.Submission
import rasterlab.grader.web.CaseView
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.comment.ONCE
import rasterlab.grader.web.comment.wordsField

/**
 * Shows below a case what its student says against the result, with the answer, and a form for what comes next.
 *
 * @param free whether somebody has no exam now, during which nobody complains
 */
class CaseComplaints(
    private val complaints: ComplaintDesk,
    private val free: (Identity) -> Boolean,
) : CaseView {
    override fun below(
        texts: PageTexts,
        who: Identity,
        submission: Submission,
        typed: Parameters?,
    ): FlowContent.(PublishedCase) -> Unit {
        val all = complaints.of(submission.id).groupBy { it.case }
        val open = who is Identity.StudentIdentity && free(who)
        return { case ->
            val about = all[case.name].orEmpty()
            about.forEach { complaint(texts, who, it, typed, null) }
            if (open && case.canBeComplainedOf() && about.none { it.current }) {
                opening(texts, submission, case, typed)
            }
        }
    }
}

/** The field by which the list of a course gets its answers back. */
internal const val FROM_LIST = "list"

/**
 * A complaint with its answer; to staff with the form that answers one that waits.
 *
 * @param typed what a form held that was refused, or null
 * @param list the course whose list it stands in; null for the page of its submission
 */
internal fun FlowContent.complaint(
    texts: PageTexts,
    who: Identity,
    one: CaseComplaint,
    typed: Parameters?,
    list: String?,
) = div("thread") {
    id = "complaint-${one.id}"
    attributes["role"] = "group"
    attributes["aria-label"] = texts.say("complaint.one")
    div("said") {
        p("by") {
            strong { +texts.say("complaint.one") }
            +" "
            span("unbroken") { +texts.say("comment.at", texts.time(one.openedAt)) }
            if (!one.current) +" · ${texts.say("complaint.earlier")}"
        }
        p("words") { +one.text }
    }
    val answer = one.answer
    if (answer == null) p("waits") { +texts.say("comment.open") } else answer(texts, who, one, answer)
    if (answer == null && who is Identity.StaffIdentity) answering(texts, who, one, typed, list)
}

private fun FlowContent.answer(
    texts: PageTexts,
    who: Identity,
    one: CaseComplaint,
    answer: ComplaintAnswer,
) = div("said") {
    p("by") {
        strong { +texts.say("complaint.state.${one.state.code}") }
        val role = texts.say("staff.role.${answer.role}")
        val author = if (answer.name.isEmpty()) role else texts.say("comment.author", answer.name, role)
        +" · $author "
        span("unbroken") { +texts.say("comment.at", texts.time(answer.at)) }
    }
    p("words") { +answer.text }
    one.regrade?.let { regrade ->
        p {
            val said = texts.say("complaint.regrade.${regrade.state.code}")
            if (who is Identity.Instructor) a("/instructor/regrades/${regrade.id}") { +said } else +said
        }
    }
}

private fun FlowContent.opening(
    texts: PageTexts,
    submission: Submission,
    case: PublishedCase,
    typed: Parameters?,
) = details("complain") {
    val refused = typed?.takeIf { it["case"] == case.name }
    open = refused != null
    summary { +texts.say("complaint.open") }
    p { +texts.say("complaint.about") }
    form("/submissions/${submission.id}/complaints", method = FormMethod.post) {
        once()
        input(InputType.hidden, name = "case") { value = case.name }
        wordsField(texts.say("complaint.text"), refused?.get("text").orEmpty())
        button { +texts.say("complaint.do") }
    }
}

private fun FlowContent.answering(
    texts: PageTexts,
    who: Identity.StaffIdentity,
    one: CaseComplaint,
    typed: Parameters?,
    list: String?,
) {
    val refused = typed?.takeIf { it["complaint"] == one.id }
    details {
        open = refused != null
        summary { +texts.say("comment.answer") }
        form("/submissions/${one.submission}/complaints/${one.id}", method = FormMethod.post) {
            input(InputType.hidden, name = "complaint") { value = one.id }
            list?.let { input(InputType.hidden, name = FROM_LIST) { value = it } }
            wordsField(texts.say("complaint.answer"), refused?.get("text").orEmpty())
            if (who is Identity.Instructor) {
                label("consent") {
                    input(InputType.checkBox, name = "regrade") {
                        value = "true"
                        checked = refused?.get("regrade") != null
                    }
                    val alone = CaseReport.ownTitle(one.case, texts.language).isEmpty
                    span { +texts.say(if (alone) "complaint.regrade" else "complaint.regrade.whole") }
                }
            }
            div("ways") {
                listOf(ComplaintState.ACCEPTED, ComplaintState.DECLINED).forEach { state ->
                    button {
                        name = "state"
                        value = state.code
                        +texts.say("complaint.do.${state.code}")
                    }
                }
            }
        }
    }
}

private fun FORM.once() = input(InputType.hidden, name = ONCE) { value = Secrets.newId() }
