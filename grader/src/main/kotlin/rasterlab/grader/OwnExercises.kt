package rasterlab.grader

import rasterlab.exercises.Exercise
import rasterlab.exercises.formula.Formulas
import rasterlab.grader.web.formulaFaults
import java.nio.file.Path

/**
 * Tells the person who starts the server about a folder of own exercises: a broken formula or an empty folder stops nothing, but would otherwise be found by a student.
 *
 * @param exercises of the folder
 * @param replaced names of those that take the place of a built-in one
 */
internal class OwnExercises(
    private val folder: Path,
    private val exercises: List<Exercise>,
    private val replaced: List<String>,
) {
    /** One line each. */
    fun told(words: CommandWords): List<String> =
        listOf(count(words)) + places(words) + exercises.flatMap { broken(it, words) }

    private fun count(words: CommandWords) =
        if (exercises.isEmpty()) {
            words.say("exercises.none", "$folder")
        } else {
            words.say("exercises.found", "$folder", "${exercises.size}", exercises.joinToString { it.id() })
        }

    private fun places(words: CommandWords) = replaced.map { words.say("exercises.replaced", it, "$folder") }

    private fun broken(
        exercise: Exercise,
        words: CommandWords,
    ): List<String> {
        val formulas = Formulas()
        return texts(exercise).flatMap { (name, markdown) ->
            val file = folder.resolve(exercise.id()).resolve(name)
            formulaFaults(markdown, formulas).map {
                words.say("exercises.formula", "$file", it.source, it.mistake.`in`(words.language.language))
            }
        }
    }

    /** Files that students read, with their texts. */
    private fun texts(exercise: Exercise): List<Pair<String, String>> =
        exercise.statement().toSortedMap().map { (language, text) -> "statement.$language.md" to text } +
            exercise.hints().flatMap { hint ->
                hint.text().toSortedMap().map { (language, text) -> "hints.$language.md" to text }
            }
}
