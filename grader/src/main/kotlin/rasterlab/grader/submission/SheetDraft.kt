package rasterlab.grader.submission

import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import rasterlab.exercises.Exercise
import rasterlab.exercises.predicting.Sheet
import kotlin.jvm.optionals.getOrNull

/**
 * Texts in the fields of a sheet's form, as an exam keeps them until they are handed in: also what is no answer yet.
 *
 * @param seed which sheet it is
 * @param typed a text for each field's name
 */
@Serializable
internal data class SheetDraft(
    val seed: Long,
    val typed: Map<String, String>,
) {
    companion object {
        /** The most characters of one field that are kept; a number has fewer. */
        private const val MOST = 60

        /** The text that is kept; empty where nothing is typed. */
        fun text(answers: TypedSheet): String {
            val typed = answers.names().associateWith { answers.text(it).take(MOST).replace("\u0000", "") }
            if (typed.values.all { it.isBlank() }) return ""
            return Json.encodeToString(SheetDraft(answers.sheet.seed(), typed))
        }

        /** The sheet with what was typed; null where the text was kept of something else. */
        fun read(
            exercise: Exercise,
            text: String,
        ): TypedSheet? {
            val rules = exercise.predicting().getOrNull() ?: return null
            val draft =
                try {
                    Json.decodeFromString<SheetDraft>(text)
                } catch (other: SerializationException) {
                    return null
                }
            return TypedSheet(exercise, Sheet.of(exercise.topic(), rules, draft.seed), draft.typed)
        }

        /** The text that is handed in for one that was kept: the document with the answers, or the text itself. */
        fun document(
            exercise: Exercise,
            text: String,
        ): String = read(exercise, text)?.source() ?: text
    }
}
