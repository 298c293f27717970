package rasterlab.grader.exam

import rasterlab.grader.course.Course
import rasterlab.grader.problem.Rejection
import rasterlab.grader.rules.RuleChange
import rasterlab.grader.storage.Secrets
import java.time.DateTimeException
import java.time.ZoneId

/** The fields that rule an exam, by their names in forms and in the HTTP API. */
enum class ExamField(
    val code: String,
) {
    NAME("name"),
    OPENS("opens"),
    CLOSES("closes"),
    ZONE("zone"),
    MINUTES("minutes"),
    STARTS("starts"),
    GRACE("grace"),
    ADDRESSES("addresses"),
    SECOND("second"),
}

/**
 * An exam as somebody wrote it.
 *
 * @param exercises their ids
 */
class ExamForm(
    private val told: Map<ExamField, String>,
    private val exercises: List<String>,
) {
    /** @throws Rejection.BadExam that names the field, what it is, and what is allowed */
    fun exam(course: Course): Exam {
        val zone = zone()
        val opens = RuleChange.moment(ExamField.OPENS.code, text(ExamField.OPENS), zone)
        val closes = RuleChange.moment(ExamField.CLOSES.code, text(ExamField.CLOSES), zone)
        if (opens >= closes) throw Rejection.BadExam("order", "$opens", "$closes")
        if (exercises.isEmpty()) throw Rejection.BadExam("exercises")
        val name = text(ExamField.NAME)
        if (name.length !in NAME || name.any { it.isISOControl() }) {
            throw Rejection.BadExam("name", name.length, NAME.last)
        }
        return Exam(
            Secrets.newId(),
            course.id,
            name,
            exercises.distinct(),
            opens,
            closes,
            zone,
            number(ExamField.MINUTES, Exam.MINUTES),
            fixed = oneOf(ExamField.STARTS, FIRST, FIXED) == FIXED,
            number(ExamField.GRACE, Exam.GRACE),
            AddressList.of(text(ExamField.ADDRESSES)) { Rejection.BadExam("address", it) },
            takesOver = oneOf(ExamField.SECOND, REFUSE, END) == END,
        )
    }

    private fun text(field: ExamField) = told[field].orEmpty().trim()

    private fun zone(): ZoneId =
        try {
            ZoneId.of(text(ExamField.ZONE).ifEmpty { "UTC" })
        } catch (misfit: DateTimeException) {
            throw Rejection.BadRule("zone", text(ExamField.ZONE))
        }

    private fun oneOf(
        field: ExamField,
        first: String,
        second: String,
    ): String {
        val text = text(field).ifEmpty { first }
        if (text != first && text != second) throw Rejection.BadExam("one.of", field.code, text, first, second)
        return text
    }

    private fun number(
        field: ExamField,
        allowed: IntRange,
    ): Int = number(field.code, text(field), allowed)

    companion object {
        const val FIRST = "first"
        const val FIXED = "fixed"
        const val REFUSE = "refuse"
        const val END = "end"
        private val NAME = 1..100

        /** The number of a field. */
        fun number(
            field: String,
            text: String,
            allowed: IntRange,
        ): Int =
            text.trim().toIntOrNull()?.takeIf { it in allowed }
                ?: throw Rejection.BadExam("number", field, text, allowed.first, allowed.last)
    }
}
