package rasterlab.grader.web

import kotlinx.html.CommonAttributeGroupFacade
import kotlinx.html.FlowContent
import kotlinx.html.FlowOrPhrasingContent
import kotlinx.html.InputType
import kotlinx.html.div
import kotlinx.html.fieldSet
import kotlinx.html.h3
import kotlinx.html.id
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.legend
import kotlinx.html.option
import kotlinx.html.p
import kotlinx.html.pre
import kotlinx.html.section
import kotlinx.html.select
import kotlinx.html.span
import rasterlab.exercises.Exercise
import rasterlab.exercises.predicting.Question
import rasterlab.exercises.predicting.Sheet
import rasterlab.exercises.predicting.StepText
import rasterlab.grader.submission.HandedForm
import rasterlab.grader.submission.SheetField
import rasterlab.grader.submission.TypedSheet
import java.util.Locale

/** The most characters that a browser takes for a number. */
private const val LONGEST_NUMBER = "60"

/** The questions of a sheet walk by walk: the data, the steps that are shown, and fields for each step asked for. */
internal fun FlowContent.questions(
    texts: PageTexts,
    exercise: Exercise,
    typed: TypedSheet,
) {
    val words = StepText(exercise.topic(), Locale.forLanguageTag(texts.language))
    input(InputType.hidden, name = HandedForm.SEED) { value = "${typed.sheet.seed()}" }
    p("legend") { +texts.say("sheet.about") }
    val walks = walks(typed.sheet)
    walks.forEachIndexed { index, walk ->
        section("walk") {
            h3 { +texts.say("sheet.data", index + 1, walks.size) }
            walkData(texts, words, walk.first())
            p("question") { +walk.first().rules().question(texts.language) }
            walk.forEach { step(texts, words, it, typed) }
        }
    }
}

private fun walks(sheet: Sheet): List<List<Question>> =
    sheet
        .questions()
        .groupBy { it.number() - it.before().size }
        .values
        .toList()

/** The input of a walk, and its steps before [question], a line each. */
internal fun FlowContent.walkData(
    texts: PageTexts,
    words: StepText,
    question: Question,
) {
    pre("data") {
        scrolledByKeys(texts.say("sheet.input"))
        +words.input(question.input()).joinToString("\n")
    }
    if (question.before().isEmpty()) return
    val shown = texts.say("sheet.shown", question.before().size)
    p("shown") { +shown }
    pre("data") {
        scrolledByKeys(shown)
        +question
            .before()
            .mapIndexed { index, step -> "${index + 1}. ${words.fieldsText(question.shown(step))}" }
            .joinToString("\n")
    }
}

private fun FlowContent.step(
    texts: PageTexts,
    words: StepText,
    question: Question,
    typed: TypedSheet,
) = fieldSet("step") {
    legend { +texts.say("sheet.step", question.number()) }
    if (!question.givenFields().isEmpty) p { +texts.say("sheet.given", words.fieldsText(question.givenFields())) }
    div("answers") {
        SheetField.of(question).forEach { part ->
            if (part.choices.isEmpty()) numbers(texts, words, part, typed) else choice(texts, words, part, typed)
        }
    }
}

private fun FlowContent.choice(
    texts: PageTexts,
    words: StepText,
    part: SheetField,
    typed: TypedSheet,
) = label("answer") {
    val field = part.names.single()
    span { +words.label(part.field) }
    select {
        name = field
        markFault(field, typed)
        option {
            value = ""
            +texts.say("sheet.none")
        }
        part.choices.forEach { choice ->
            option {
                value = choice
                selected = typed.text(field) == choice
                +words.word(choice)
            }
        }
    }
    fault(texts, field, typed)
}

private fun FlowContent.numbers(
    texts: PageTexts,
    words: StepText,
    part: SheetField,
    typed: TypedSheet,
) = div("answer") {
    val called = words.label(part.field)
    span("called") {
        id = "${part.names.first()}-called"
        +called
    }
    part.names.forEachIndexed { index, field ->
        span("number-field") {
            input(InputType.text, name = field) {
                value = typed.text(field)
                attributes["autocomplete"] = "off"
                attributes["maxlength"] = LONGEST_NUMBER
                attributes["aria-label"] = if (part.names.size == 1) called else "$called, ${index + 1}"
                markFault(field, typed)
            }
            fault(texts, field, typed)
        }
    }
}

/** Marks a field that is wrong; the first of them gets the keyboard. */
private fun CommonAttributeGroupFacade.markFault(
    field: String,
    typed: TypedSheet,
) {
    if (field !in typed.faults) return
    attributes["aria-invalid"] = "true"
    attributes["aria-describedby"] = "$field-fault"
    if (typed.faults.keys.first() == field) attributes["autofocus"] = "autofocus"
}

private fun FlowOrPhrasingContent.fault(
    texts: PageTexts,
    field: String,
    typed: TypedSheet,
) {
    val fault = typed.faults[field] ?: return
    span("fault") {
        id = "$field-fault"
        +texts.say("sheet.fault.${fault.code}")
    }
}
