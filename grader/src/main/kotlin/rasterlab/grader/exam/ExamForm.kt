package rasterlab.grader.exam

import rasterlab.grader.course.Course
import rasterlab.grader.problem.Rejection
import rasterlab.grader.rules.RuleChange
import rasterlab.grader.rules.named
import rasterlab.grader.rules.withOffset
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
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
    /**
     * A new exam of a course.
     *
     * @throws Rejection.BadExam that names the field, what it is, and what is allowed
     */
    fun exam(course: Course): Exam = exam(Secrets.newId(), course.id)

    private fun exam(
        id: String,
        course: String,
    ): Exam {
        val zone = zone()
        val opens = RuleChange.moment(ExamField.OPENS.code, text(ExamField.OPENS), zone, begins = true)
        val closes = RuleChange.moment(ExamField.CLOSES.code, text(ExamField.CLOSES), zone)
        if (opens >= closes) throw Rejection.BadExam("order", opens.withOffset(zone), closes.withOffset(zone))
        if (exercises.isEmpty()) throw Rejection.BadExam("exercises")
        val name = text(ExamField.NAME)
        if (name.length !in NAME || name.any { it.isISOControl() }) {
            throw Rejection.BadExam("name", name.length, NAME.last)
        }
        return Exam(
            id,
            course,
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

        /** An exam in the words that a form has for it. */
        fun told(exam: Exam): Map<ExamField, String> =
            mapOf(
                ExamField.NAME to exam.name,
                ExamField.OPENS to exam.opens.text(),
                ExamField.CLOSES to exam.closes.text(),
                ExamField.ZONE to exam.zone.named(),
                ExamField.MINUTES to "${exam.minutes}",
                ExamField.STARTS to if (exam.fixed) FIXED else FIRST,
                ExamField.GRACE to "${exam.grace}",
                ExamField.ADDRESSES to exam.addresses.text,
                ExamField.SECOND to if (exam.takesOver) END else REFUSE,
            )

        /**
         * An exam with something else in the place of what it was.
         *
         * @param told what is to be changed; what is not told stays
         * @param exercises their ids; null for those that it has
         * @param begun whether a student has begun it: then its exercises and its beginning stay
         * @throws Rejection.BadExam that names the field, what it is, and what is allowed
         */
        fun changed(
            before: Exam,
            told: Map<ExamField, String>,
            exercises: List<String>?,
            begun: Boolean,
        ): Exam {
            val after = ExamForm(told(before) + told, exercises ?: before.exercises).exam(before.id, before.course)
            if (begun) {
                val same =
                    mapOf(
                        "exercises" to (after.exercises == before.exercises),
                        ExamField.OPENS.code to (after.opens == before.opens),
                        ExamField.STARTS.code to (after.fixed == before.fixed),
                    )
                same.entries.firstOrNull { !it.value }?.let { throw Rejection.BadExam("begun.fixed", it.key) }
            }
            return after
        }

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
