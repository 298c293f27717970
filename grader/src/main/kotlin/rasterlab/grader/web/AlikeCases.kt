package rasterlab.grader.web

import rasterlab.exercises.published.PublishedCase
import rasterlab.exercises.score.GradingVerdict

/** The least number of failures, told the same, that are shown as one row which opens. */
private const val MANY = 3

/** Whether it earned all its points. */
internal fun PublishedCase.passed(): Boolean = verdict.codeFor(points, of) == GradingVerdict.OK.code()

/** The cases in their order, many failures with one verdict and one message as a group at the place of the first. */
internal fun alike(cases: List<PublishedCase>): List<List<PublishedCase>> =
    cases
        .groupBy { listOf(it.verdict.codeFor(it.points, it.of), it.message, it.visibility) }
        .values
        .flatMap { group ->
            val alike = group.size >= MANY && group.none { it.passed() } && group.first().message.isNotEmpty()
            if (alike) listOf(group) else group.map(::listOf)
        }.sortedBy { cases.indexOf(it.first()) }
