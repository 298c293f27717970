// The exercises that students are given.
package rasterlab.grader.exercise

import rasterlab.exercises.Exercise
import rasterlab.grader.problem.Rejection

/**
 * The exercises that this server gives and grades.
 *
 * @param kept an exercise as it was at that revision, by id and revision, or null where that is not known
 */
class Exercises(
    val all: List<Exercise>,
    private val kept: (String, String) -> Exercise? = { _, _ -> null },
) {
    private val byId = all.associateBy(Exercise::id)

    fun named(id: String): Exercise = byId[id] ?: throw Rejection.UnknownExercise(id)

    /** How the name of a file ends that is handed in for an exercise, which may be gone. */
    fun ending(id: String): String = find(id)?.form()?.ending() ?: "txt"

    /** Finds an exercise for work that was accepted when the catalogue may have been another. */
    fun find(id: String): Exercise? = byId[id]

    /**
     * The exercise as it was at that revision; where that is not known, as it is now, or null if it
     * is not here any more.
     */
    fun at(
        id: String,
        revision: String,
    ): Exercise? = if (isCurrent(id, revision)) byId[id] else kept(id, revision) ?: byId[id]

    fun isCurrent(
        id: String,
        revision: String,
    ): Boolean = byId[id]?.revision() == revision
}
