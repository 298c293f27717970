// The exercises that students are given.
package rasterlab.grader.exercise

import rasterlab.exercises.Exercise
import rasterlab.grader.problem.Rejection

/** The exercises that this server gives and grades. */
class Exercises(
    val all: List<Exercise>,
) {
    private val byId = all.associateBy(Exercise::id)

    fun named(id: String): Exercise = byId[id] ?: throw Rejection.UnknownExercise(id)

    /** For work that was accepted when the catalogue may have been another. */
    fun find(id: String): Exercise? = byId[id]
}
