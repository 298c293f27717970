package rasterlab.grader.report

import rasterlab.exercises.Exercise

/**
 * The files that show a submission's failed cases in the lab: no two submissions of a student have files of one
 * name.
 *
 * @param form what is handed in: beside a program's right method the lab shows the program
 */
class LabFiles(
    private val exercise: String,
    private val attempt: Int,
    private val form: Exercise.Form,
) {
    val asksForPrograms = form == Exercise.Form.WRITE

    /** What was handed in. */
    val source = "$exercise-$attempt.${form.ending()}"

    fun scene(case: String) = "$exercise-$attempt-$case.scene.json"

    /** The command that opens a case. */
    fun command(case: String): String {
        val opened = "./lab open ${scene(case)}"
        return if (asksForPrograms) "$opened --exercise $exercise --with $source" else opened
    }
}

/** A text that a browser saves under [name]. */
class SavedFile(
    val name: String,
    val mediaType: String,
    val text: String,
)
