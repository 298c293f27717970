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
    /** The seed of each submission draws these inputs, so answers to them are those of other questions. */
    private val drawn =
        exercise
            .cases()
            .filter { it.generated() }
            .map { it.name() }
            .toSet()

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
        if (exercise.form() != Exercise.TaskKind.WRITE) {
            emptyList()
        } else {
            results
                .groupBy { telling(it).let { marks -> if (marks.isEmpty()) "" else hash(fingerprint(marks)) } }
                .filter { (id, members) -> id.isNotEmpty() && members.size > 1 }
                .map { (id, members) -> group(id, members) }
                .sortedWith(compareByDescending<WrongGroup> { it.members.size }.thenBy { it.members.first().name })
        }

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
            name !in drawn && marks.any { it.pixels },
        )
    }

    private fun group(
        id: String,
        members: List<LastResult>,
    ): WrongGroup {
        val marks = telling(members.first())
        return WrongGroup(id.take(ID), members, marks.map { it.name }, mistake(members, marks))
    }

    /** The failed cases that all were asked alike; where there are none, those that were drawn for each. */
    private fun telling(result: LastResult): List<CaseMark> {
        val failed = result.cases.filter { !it.passed && it.verdict != GradingVerdict.NOT_RUN }
        return failed.filter { it.name !in drawn }.ifEmpty { failed }
    }

    private fun fingerprint(marks: List<CaseMark>) =
        marks
            .joinToString("\n") { mark ->
                val answer = if (mark.name in drawn) "" else "${mark.answer} ${mark.picture}"
                "${mark.name} ${mark.verdict} $answer"
            }.toByteArray()

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

        /** Letters of a hash that tell a group from every other one of its exercise. */
        const val ID = 16
    }
}
