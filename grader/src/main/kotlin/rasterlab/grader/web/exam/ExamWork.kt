package rasterlab.grader.web.exam

import kotlinx.html.FORM
import kotlinx.html.FlowContent
import kotlinx.html.FormEncType
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.input
import kotlinx.html.p
import kotlinx.html.role
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Identity
import rasterlab.grader.exam.Draft
import rasterlab.grader.exam.Sitting
import rasterlab.grader.exercise.starterFile
import rasterlab.grader.storage.Secrets
import rasterlab.grader.submission.HandedForm
import rasterlab.grader.submission.SheetDraft
import rasterlab.grader.submission.Sheets
import rasterlab.grader.submission.TypedSheet
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.Refused
import rasterlab.grader.web.problem
import rasterlab.grader.web.questions

/**
 * The sheet that the next attempt answers, with what is typed by now; null where there is none, or the draft is a text
 * of another kind.
 */
internal fun sheet(
    sheets: Sheets,
    student: Identity.StudentIdentity,
    exercise: Exercise,
    draft: Draft?,
): TypedSheet? {
    val next = sheets.next(student, exercise) ?: return null
    val typed = draft?.let { SheetDraft.read(exercise, it.source) }
    if (typed == null && !draft?.source.isNullOrBlank() && !draft.handed) return null
    return typed?.takeIf { it.sheet.seed() == next.seed() } ?: TypedSheet(exercise, next, emptyMap())
}

/**
 * Where a student works on an exercise of an exam.
 *
 * @param sheet whose questions are asked; null where a text is asked for
 * @param refused why it was not taken; null where it was not sent
 * @param text the field for a text
 */
internal fun FlowContent.work(
    texts: PageTexts,
    sitting: Sitting,
    exercise: Exercise,
    draft: Draft?,
    sheet: TypedSheet?,
    refused: Refused?,
    text: FORM.() -> Unit,
) = div("card") {
    val address = "/exams/${sitting.exam.id}/exercises/${exercise.id()}"
    val starter = if (sheet == null) "exercise.starter" else "exercise.sheet"
    p { a("/exercises/${exercise.id()}/starter") { +"${texts.say(starter)} (${exercise.starterFile()})" } }
    refused?.let { problem(texts, it.status, it.code, it.details) }
    form(address, encType = FormEncType.multipartFormData, method = FormMethod.post) {
        attributes["data-draft"] = "$address/draft"
        attributes["data-kept"] = "$address ${sitting.student} ${sheet?.sheet?.seed() ?: ""}".trim()
        attributes["data-saved"] = texts.say("exam.saved")
        attributes["data-failed"] = texts.say("exam.failed")
        input(InputType.hidden, name = HandedForm.ONCE) { value = Secrets.newId() }
        if (sheet == null) text() else questions(texts, exercise, sheet)
        p("legend status-line") {
            role = "status"
            +texts.say(stateOf(draft))
        }
        div("ways") {
            button { +texts.say("exercise.submit.do") }
            button(classes = "plain") {
                formAction = "$address/draft"
                +texts.say("exam.save")
            }
        }
    }
}

private fun stateOf(draft: Draft?) =
    when {
        draft == null -> "exam.draft.none"
        draft.handed -> "exam.draft.handed"
        else -> "exam.draft.kept"
    }
