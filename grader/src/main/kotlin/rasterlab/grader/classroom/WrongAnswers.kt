package rasterlab.grader.classroom

import rasterlab.exercises.Exercise
import rasterlab.exercises.score.GradingVerdict
import rasterlab.grader.submission.hash

/** Tells which results of an exercise have the same wrong answers. */
internal class WrongAnswers(
    private val exercise: Exercise,
) {
    /** The seed of each submission draws these inputs, so answers to them are those of other questions. */
    val drawn =
        exercise
            .cases()
            .filter { it.generated() }
            .map { it.name() }
            .toSet()

    /** The failed cases that all were asked alike; where there are none, those that were drawn for each. */
    fun telling(result: LastResult): List<CaseMark> {
        val failed = result.cases.filter { !it.passed && it.verdict != GradingVerdict.NOT_RUN }
        return failed.filter { it.name !in drawn }.ifEmpty { failed }
    }

    /** The id of all results with these answers; null where nothing is wrong, or where no program answers. */
    fun groupOf(result: LastResult): String? {
        if (exercise.form() != Exercise.TaskKind.WRITE) return null
        val marks = telling(result)
        return if (marks.isEmpty()) null else hash(fingerprint(marks)).take(ID)
    }

    private fun fingerprint(marks: List<CaseMark>) =
        marks
            .joinToString("\n") { mark ->
                val answer = if (mark.name in drawn) "" else "${mark.answer} ${mark.picture}"
                "${mark.name} ${mark.verdict} $answer"
            }.toByteArray()

    private companion object {
        /** Letters of a hash that tell a group from every other one of its exercise. */
        const val ID = 16
    }
}
