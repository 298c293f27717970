package rasterlab.grader.submission

import rasterlab.exercises.Exercise
import rasterlab.exercises.predicting.Sheet
import rasterlab.grader.problem.Rejection
import rasterlab.grader.rules.ExerciseRules
import rasterlab.grader.storage.Secrets
import kotlin.jvm.optionals.getOrNull

/**
 * The contents that a page's form hands in: a file, a text, or the answers to the questions of a sheet.
 *
 * @property answers null where the form has no questions
 */
internal class HandedForm private constructor(
    private val fields: List<FormField>,
    val answers: TypedSheet?,
) {
    /** Whether the student agrees that it is marked as late. */
    val late: Boolean = text(LATE) == ACCEPT

    /** The percentage of its points that the student agrees to lose for that, at most; 0 where the page asked for none. */
    val percent: Int = text(PERCENT).toIntOrNull()?.takeIf { it in ExerciseRules.PERCENT } ?: 0

    /** Whether it is only to be shown once more, as in another language, and not handed in. */
    val again: Boolean = text(AGAIN).isNotEmpty()

    /** The file or the text as it can be shown again; empty where it is no text. */
    val kept: String =
        sent()
            ?.content
            ?.takeIf { it.size <= LONGEST_SOURCE_BYTES }
            ?.decodeToString()
            ?.takeIf { '\uFFFD' !in it && '\u0000' !in it }
            .orEmpty()

    /** The name of the file that [kept] is the text of, or null. */
    val file: String? = sent()?.file?.takeIf { kept.isNotEmpty() }

    private fun sent() = fields.firstOrNull { it.name == "source" && it.content.isNotEmpty() }

    private fun text(name: String) =
        fields
            .firstOrNull { it.name == name }
            ?.content
            ?.decodeToString()
            .orEmpty()

    /** The text that is handed in; a sheet is the JSON document that programs send. */
    fun source(): String {
        if (answers == null) return sourceOf(fields)
        if (answers.faults.isNotEmpty()) throw Rejection.BadAnswers(answers.faults.size)
        return answers.source()
    }

    /**
     * A key that is the same when one page sends one source again, as by a double click. Its space keeps
     * it apart from those that programs choose. Another source from the same page is another attempt.
     */
    fun once(source: String): String? =
        text(ONCE).takeIf { it.isNotEmpty() }?.let { "page ${Secrets.hash(it + "\n" + source)}" }

    companion object {
        /** The field that tells one opened page from the next. */
        const val ONCE = "once"

        /** The field that asks for the form once more as it is filled in. */
        const val AGAIN = "again"

        /** The field that says how much of its points lateness costs, as the page has it. */
        const val PERCENT = "percent"

        /** The field that says which sheet the answers are to. */
        const val SEED = "seed"

        fun of(
            exercise: Exercise,
            fields: List<FormField>,
        ): HandedForm = HandedForm(fields, answers(exercise, fields))

        private fun answers(
            exercise: Exercise,
            fields: List<FormField>,
        ): TypedSheet? {
            val rules = exercise.predicting().getOrNull() ?: return null
            val told = fields.firstOrNull { it.name == SEED }?.content?.decodeToString() ?: return null
            val seed =
                told.toLongOrNull()?.takeIf { it in 0..Sheet.MOST_SEED }
                    ?: throw Rejection.Malformed("the form's field '$SEED' must be the one that the page has")
            val typed = fields.filter { it.file == null }.associate { it.name to it.content.decodeToString() }
            return TypedSheet(exercise, Sheet.of(exercise.topic(), rules, seed), typed)
        }
    }
}
