package rasterlab.grader.submission

import com.fasterxml.jackson.databind.JsonNode
import com.fasterxml.jackson.databind.node.BooleanNode
import com.fasterxml.jackson.databind.node.JsonNodeFactory
import com.fasterxml.jackson.databind.node.ObjectNode
import com.fasterxml.jackson.databind.node.TextNode
import rasterlab.exercises.Exercise
import rasterlab.exercises.Predicting.PredictedField
import rasterlab.exercises.predicting.Question
import rasterlab.exercises.predicting.Sheet
import rasterlab.exercises.predicting.SheetText
import rasterlab.exercises.predicting.TypedValue

/**
 * A part of an answer as a page's form asks for it: one choice among words, or a text for each number.
 *
 * @property choices the words; none where numbers are asked for
 * @property names of the form's fields, in the order of the numbers
 */
class SheetField(
    question: Question,
    asked: PredictedField,
) {
    val field: String = asked.field()
    private val right: JsonNode = question.right().path(field)
    val choices: List<String> =
        if (asked.words().isEmpty() && right.isBoolean) listOf("true", "false") else asked.words()
    val names: List<String> =
        "answer-${question.number()}-$field".let { name ->
            val count = if (choices.isEmpty()) TypedValue.count(right) else 1
            if (count == 1) listOf(name) else List(count) { "$name-${it + 1}" }
        }

    /** The value of these texts, null where nothing is typed; [faults] is told what is none, by name and kind. */
    fun read(
        typed: (String) -> String,
        faults: (String, AnswerFault) -> Unit,
    ): JsonNode? {
        val texts = names.associateWith { typed(it).trim() }
        return when {
            texts.values.all { it.isEmpty() } -> null
            choices.isNotEmpty() -> choice(texts.getValue(names.single()), faults)
            else -> numbers(texts, faults)
        }
    }

    private fun choice(
        word: String,
        faults: (String, AnswerFault) -> Unit,
    ): JsonNode? {
        if (word !in choices) faults(names.single(), AnswerFault.CHOICE)
        return when {
            word !in choices -> null
            right.isBoolean -> BooleanNode.valueOf(word.toBoolean())
            else -> TextNode.valueOf(word)
        }
    }

    private fun numbers(
        texts: Map<String, String>,
        faults: (String, AnswerFault) -> Unit,
    ): JsonNode? {
        val numbers = texts.mapValues { (_, text) -> TypedValue.number(text) }
        for ((name, number) in numbers) {
            if (number.isPresent) continue
            faults(name, if (texts.getValue(name).isEmpty()) AnswerFault.PART else AnswerFault.NUMBER)
        }
        if (numbers.values.any { it.isEmpty }) return null
        return TypedValue.formed(right, numbers.values.map { it.get() }.iterator())
    }

    companion object {
        fun of(question: Question): List<SheetField> = question.rules().asked().map { SheetField(question, it) }
    }
}

/** Why a text is no answer; [code] names the words of pages. */
enum class AnswerFault {
    NUMBER,
    PART,
    CHOICE,
    ;

    val code get() = name.lowercase()
}

/** A sheet with what is typed into the form of a page, a text for each field's name. */
class TypedSheet(
    private val exercise: Exercise,
    val sheet: Sheet,
    private val typed: Map<String, String>,
) {
    private val found = mutableMapOf<String, AnswerFault>()
    private val answers = sheet.questions().associate { it.number() to answer(it) }

    /** The fields whose texts are no answer. */
    val faults: Map<String, AnswerFault> get() = found

    /** The names of all fields. */
    fun names(): List<String> = sheet.questions().flatMap { SheetField.of(it) }.flatMap { it.names }

    fun text(name: String): String = typed[name].orEmpty()

    /** The document that the API takes. */
    fun source(): String = SheetText.written(exercise.id(), sheet) { answers.getValue(it.number()) }

    private fun answer(question: Question): ObjectNode {
        val answer = JsonNodeFactory.instance.objectNode()
        for (part in SheetField.of(question)) {
            part.read(::text, found::put)?.let { answer.set<JsonNode>(part.field, it) }
        }
        return answer
    }
}
