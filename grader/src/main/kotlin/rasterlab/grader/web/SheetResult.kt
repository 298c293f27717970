package rasterlab.grader.web

import com.fasterxml.jackson.databind.JsonNode
import com.fasterxml.jackson.databind.node.JsonNodeFactory
import kotlinx.html.FlowContent
import kotlinx.html.dd
import kotlinx.html.details
import kotlinx.html.dl
import kotlinx.html.dt
import kotlinx.html.p
import kotlinx.html.summary
import rasterlab.exercises.CatalogueException
import rasterlab.exercises.Exercise
import rasterlab.exercises.Predicting
import rasterlab.exercises.predicting.HandedAnswers
import rasterlab.exercises.predicting.Question
import rasterlab.exercises.predicting.StepText
import java.util.Locale

/** The steps of a sheet that was handed in: what was asked, what was answered, what is right, and why. */
class SheetResult private constructor(
    private val topic: String,
    private val handed: HandedAnswers,
) {
    /** The step that a case judges, or null where it judges none. */
    fun step(case: String): Question? = handed.sheet().questions().firstOrNull { Predicting.step(it.number()) == case }

    fun answer(question: Question): JsonNode = handed.answers()[question.number() - 1]

    fun words(language: String) = StepText(topic, Locale.forLanguageTag(language))

    companion object {
        /** The result of a sheet; null where no steps were asked for, or where the answers cannot be read. */
        fun of(
            exercise: Exercise?,
            source: String,
        ): SheetResult? {
            if (exercise?.form() != Exercise.TaskKind.PREDICT) return null
            return try {
                SheetResult(exercise.topic(), HandedAnswers.of(exercise, source.removePrefix("\uFEFF")))
            } catch (invalid: CatalogueException) {
                // An exercise that has changed may ask for other steps; the report says what it can.
                null
            }
        }
    }
}

/** One step of a result. */
internal fun FlowContent.stepResult(
    texts: PageTexts,
    sheet: SheetResult,
    question: Question,
) {
    val words = sheet.words(texts.language)
    val answer = sheet.answer(question)
    p("question") {
        +question.rules().question(texts.language)
        if (!question.givenFields().isEmpty) +" ${texts.say("sheet.given", words.fieldsText(question.givenFields()))}"
    }
    dl("predicted") {
        dt { +texts.say("sheet.mine") }
        dd { +if (question.isOpen(answer)) texts.say("sheet.open") else words.fieldsText(answered(question, answer)) }
        dt { +texts.say("sheet.right") }
        dd { +words.fieldsText(question.right()) }
        dt { +texts.say("sheet.why") }
        dd { +words.localised(question.why().`in`(texts.language)) }
    }
    details {
        summary { +texts.say("sheet.walk") }
        walkData(texts, words, question)
    }
}

private fun answered(
    question: Question,
    answer: JsonNode,
): JsonNode {
    val part = JsonNodeFactory.instance.objectNode()
    question.rules().asked().forEach { part.set<JsonNode>(it.field(), answer.path(it.field())) }
    return part
}
