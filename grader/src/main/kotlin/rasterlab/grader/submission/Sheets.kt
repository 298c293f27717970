package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import rasterlab.exercises.CatalogueException
import rasterlab.exercises.Exercise
import rasterlab.exercises.predicting.HandedAnswers
import rasterlab.exercises.predicting.Sheet
import rasterlab.exercises.predicting.SheetText
import rasterlab.exercises.score.Phrase
import rasterlab.grader.course.Identity
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Secrets
import kotlin.jvm.optionals.getOrNull

/**
 * The sheets of questions of exercises whose steps are predicted: one for each student and attempt, which nobody
 * chooses. An exercise that was changed has other ones.
 */
class Sheets(
    private val database: Database,
) {
    /** The starter; a sheet where the exercise asks for predictions. */
    fun starter(
        who: Identity,
        exercise: Exercise,
    ): String = next(who, exercise)?.let { SheetText.open(exercise.id(), it) } ?: exercise.starter()

    /**
     * A student's sheet of the next attempt, anybody else's to try; null where the exercise asks for no predictions.
     */
    fun next(
        who: Identity,
        exercise: Exercise,
    ): Sheet? {
        val rules = exercise.predicting().getOrNull() ?: return null
        val student = who as? Identity.StudentIdentity
        val seed = student?.let { database.write { handle -> seed(handle, it.id, exercise) } } ?: SheetText.freshSeed()
        return Sheet.of(exercise.topic(), rules, seed)
    }

    companion object {
        /** The seed of the sheet that the student's next attempt answers. */
        fun seed(
            handle: Handle,
            student: String,
            exercise: Exercise,
        ): Long {
            val attempt =
                handle
                    .createQuery(
                        """SELECT coalesce(max(attempt), 0) + 1 FROM submissions
                           WHERE student_id = :student AND exercise = :exercise""",
                    ).bind("student", student)
                    .bind("exercise", exercise.id())
                    .mapTo(Int::class.javaObjectType)
                    .one()
            val drawn = Secrets.derive(handle, "sheet ${exercise.id()} ${exercise.revision()} $student $attempt")
            return drawn.encodeToByteArray().fold(0L) { seed, byte -> 31 * seed + byte } and Sheet.MOST_SEED
        }

        /**
         * The seed that a sheet came with.
         *
         * @throws Rejection.BadSheet where it cannot be read, or answers nothing
         */
        fun handedSeed(
            exercise: Exercise,
            source: String,
        ): Long {
            val handed = handed(exercise, source)
            if (handed.isAnswered) return handed.sheet().seed()
            throw Rejection.BadSheet(CatalogueException(Phrase.of("predict.unanswered", handed.answers().size)))
        }

        private fun handed(
            exercise: Exercise,
            source: String,
        ): HandedAnswers =
            try {
                HandedAnswers.of(exercise, source.removePrefix("\uFEFF"))
            } catch (invalid: CatalogueException) {
                throw Rejection.BadSheet(invalid)
            }

        /** @throws Rejection.BadSheet where it is another attempt's */
        fun requireSeed(
            handed: Long,
            expected: Long,
        ) {
            if (handed == expected) return
            val other = Phrase.of("predict.other-seed", "$handed", "$expected")
            throw Rejection.BadSheet(CatalogueException(other))
        }
    }
}
