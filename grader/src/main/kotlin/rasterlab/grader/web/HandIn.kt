package rasterlab.grader.web

import kotlinx.html.FORM
import kotlinx.html.FlowContent
import kotlinx.html.FormEncType
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.button
import kotlinx.html.details
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.id
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.p
import kotlinx.html.span
import kotlinx.html.summary
import rasterlab.exercises.Exercise
import rasterlab.exercises.predicting.SheetText
import rasterlab.grader.storage.Secrets
import rasterlab.grader.submission.ACCEPT
import rasterlab.grader.submission.HandedForm
import rasterlab.grader.submission.LATE

private const val STEPS_FORM = "steps"
private const val WHOLE_FORM = "whole"

/** The form that was filled in; null where none was sent yet. */
internal fun ExerciseStand.filled(): String? =
    form?.let { if (sheet != null && it.answers != null) STEPS_FORM else WHOLE_FORM }

/** Where to hand in: a file or its text; the questions of a sheet come first, each with its fields. */
internal fun FlowContent.handIn(
    texts: PageTexts,
    stand: ExerciseStand,
    refused: Refused?,
) {
    h2 { +texts.say("exercise.submit") }
    refused?.let { problem(texts, it.status, it.code, it.details) }
    if (stand.sheet == null) {
        whole(texts, stand, stand.form?.kept.orEmpty())
        return
    }
    handing(texts, stand, STEPS_FORM) { questions(texts, stand.exercise, stand.sheet) }
    val document =
        stand.form
            ?.takeIf { it.answers == null }
            ?.kept
            .orEmpty()
    details("document") {
        open = document.isNotEmpty()
        summary { +texts.say("sheet.document") }
        whole(texts, stand, document.ifEmpty { SheetText.open(stand.exercise.id(), stand.sheet.sheet) })
    }
}

/** A file, or a text in its place. */
private fun FlowContent.whole(
    texts: PageTexts,
    stand: ExerciseStand,
    text: String,
) = handing(texts, stand, WHOLE_FORM) {
    val form = stand.exercise.form()
    label {
        span { +texts.say("exercise.file.${form.code()}") }
        input(InputType.file, name = "source") { accept = ".${form.ending()},${form.mediaType()}" }
    }
    stand.form?.file?.let { p { +texts.say("exercise.kept", it) } }
    val rows = if (form == Exercise.TaskKind.PREDICT) 14 else 10
    sourceField(texts.say("exercise.paste.${form.code()}"), form.ending(), text, rows)
}

/** Has what is typed kept in the browser until it is handed in. */
private fun FORM.keepTyped(
    texts: PageTexts,
    stand: ExerciseStand,
) {
    attributes["data-typed"] = "typed $action ${stand.who.id}"
    attributes["data-attempts"] = "${stand.mine.orEmpty().maxOfOrNull { it.submission.attempt } ?: 0}"
    attributes["data-back"] = texts.say("exercise.typed.back")
    attributes["data-drop"] = texts.say("exercise.typed.drop")
}

/** A form that hands in what [content] asks for, with what a deadline that has passed asks besides. */
private fun FlowContent.handing(
    texts: PageTexts,
    stand: ExerciseStand,
    name: String,
    content: FORM.() -> Unit,
) = form("/exercises/${stand.exercise.id()}", encType = FormEncType.multipartFormData, method = FormMethod.post) {
    id = name
    if (stand.sheet == null) keepTyped(texts, stand)
    input(InputType.hidden, name = HandedForm.ONCE) { value = Secrets.newId() }
    content()
    input(InputType.hidden, name = HandedForm.PERCENT) { value = "${stand.rules.penalty(stand.now)}" }
    texts.consent(stand.rules, stand.now)?.let { consent(it, agreed = stand.form?.late == true) }
    button { +texts.say("exercise.submit.do") }
}

private fun FlowContent.consent(
    what: String,
    agreed: Boolean,
) = label("consent") {
    input(InputType.checkBox, name = LATE) {
        value = ACCEPT
        required = true
        checked = agreed
    }
    span { +what }
}
