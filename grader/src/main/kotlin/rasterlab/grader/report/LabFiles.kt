package rasterlab.grader.report

import rasterlab.exercises.Exercise
import rasterlab.exercises.catalogue.Catalogue

/** The name that the lab on a student's machine gives the exercise that a program was written for. */
sealed interface InLab {
    /** The lab has it itself. */
    data object Known : InLab

    /** The lab has another one, [id], that takes the same programs. */
    data class Like(
        val id: String,
    ) : InLab

    /** The lab has to be given the folder of the course's exercises. */
    data object FromFolder : InLab

    companion object {
        private val builtIn by lazy { Catalogue.builtIn().all().filter { it.form() == Exercise.TaskKind.WRITE } }

        /** The kind of [exercise]; one that is not here any more is taken for one of the lab's. */
        fun of(exercise: Exercise?): InLab {
            if (exercise == null || exercise.form() != Exercise.TaskKind.WRITE) return Known
            val like = builtIn.filter { it.topic() == exercise.topic() && it.contract() == exercise.contract() }
            return when {
                like.any { it.id() == exercise.id() } -> Known
                like.isEmpty() -> FromFolder
                else -> Like(like.first().id())
            }
        }
    }
}

/**
 * The files that show a submission's failed cases in the lab: no two submissions of a student have files of one
 * name.
 *
 * @param form what is handed in: beside a program's right method the lab shows the program
 * @param inLab what the exercise is in the lab that opens the files
 */
class LabFiles(
    private val exercise: String,
    private val attempt: Int,
    private val form: Exercise.TaskKind,
    val inLab: InLab,
) {
    val asksForPrograms = form == Exercise.TaskKind.WRITE

    /** The text that was handed in. */
    val source = "$exercise-$attempt.${form.ending()}"

    fun scene(case: String) = "$exercise-$attempt-$case.scene.json"

    /** The command that opens a case. */
    fun command(case: String): String {
        val opened = "./lab open ${scene(case)}"
        return if (asksForPrograms) "$opened $named --with $source" else opened
    }

    private val named =
        when (inLab) {
            InLab.Known -> "--exercise $exercise"
            is InLab.Like -> "--exercise ${inLab.id}"
            InLab.FromFolder -> "--exercises FOLDER --exercise $exercise"
        }
}

/** A text that a browser saves under [name]. */
class SavedFile(
    val name: String,
    val mediaType: String,
    val text: String,
)
