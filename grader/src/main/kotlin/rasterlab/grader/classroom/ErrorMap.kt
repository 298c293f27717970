package rasterlab.grader.classroom

import rasterlab.exercises.Exercise
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Message

/**
 * The results of a class for one case.
 *
 * @param notRun for how many the method was stopped before
 * @param summed whether differences of several students can be laid over each other
 */
class MappedCase(
    val name: String,
    val visibility: Disclosure,
    val passed: Int,
    val failed: Int,
    val notRun: Int,
    val summed: Boolean,
) {
    /** Whether it was tried, and nobody passed. */
    val nobodyPasses get() = passed == 0 && failed > 0
}

/**
 * Students who gave the same wrong answers to the same cases.
 *
 * @param id the same as long as the answers are
 * @param cases names of those that tell the group from others
 * @param mistake that is known to give these answers; nothing where none is
 */
class WrongGroup(
    val id: String,
    val members: List<LastResult>,
    val cases: List<String>,
    val mistake: Message,
)

/** The last results of a class for an exercise: cases against students. */
class ErrorMap(
    val results: List<LastResult>,
    private val exercise: Exercise,
) {
    private val wrong = WrongAnswers(exercise)

    private val places = exercise.cases().withIndex().associate { (place, case) -> case.name() to place }

    /** The cases in the order of the exercise; those that it has no more come last. */
    val cases: List<MappedCase> =
        results
            .flatMap { it.cases }
            .groupBy { it.name }
            .map { (name, marks) -> mapped(name, marks) }
            .sortedBy { case -> places[case.name] ?: Int.MAX_VALUE }

    /** The students of whose work nothing ran. */
    val withoutCases: List<LastResult> = results.filter { it.cases.isEmpty() }

    /** Two or more students each, the biggest first; only programs have answers that can be compared. */
    val groups: List<WrongGroup> =
        results
            .mapNotNull { one -> wrong.groupOf(one)?.let { it to one } }
            .groupBy({ it.first }, { it.second })
            .filterValues { it.size > 1 }
            .map { (id, members) -> group(id, members) }
            .sortedWith(compareByDescending<WrongGroup> { it.members.size }.thenBy { it.members.first().name })

    private fun mapped(
        name: String,
        marks: List<CaseMark>,
    ): MappedCase {
        val notRun = marks.count { it.verdict == GradingVerdict.NOT_RUN }
        val passed = marks.count { it.passed }
        return MappedCase(
            name,
            marks.last().visibility,
            passed,
            marks.size - passed - notRun,
            notRun,
            name !in wrong.drawn && marks.any { it.pixels },
        )
    }

    private fun group(
        id: String,
        members: List<LastResult>,
    ): WrongGroup {
        val marks = wrong.telling(members.first())
        return WrongGroup(id, members, marks.map { it.name }, mistake(members, marks))
    }

    /** The mistake that a report tells to explain all that is wrong, or else the one that each of [marks] shows. */
    private fun mistake(
        members: List<LastResult>,
        marks: List<CaseMark>,
    ): Message =
        members.map { it.shared }.firstOrNull { !it.isEmpty }
            ?: marks
                .map { mark ->
                    mark.said.sentences
                        .filter { it.key in NAMING || it.key.startsWith("mistake.") }
                        .toSet()
                }.reduce { common, those -> common intersect those }
                .firstOrNull()
                ?.let { Message(listOf(it)) }
            ?: Message.NONE

    private companion object {
        /** Keys of sentences that name a mutant, a slip or a faulty method of the topic. */
        val NAMING = setOf("known-mistake", "known-fault", "known-fault.told")
    }
}
