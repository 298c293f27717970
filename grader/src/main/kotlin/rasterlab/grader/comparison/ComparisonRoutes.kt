package rasterlab.grader.comparison

import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.exercises.published.PublishedCase
import rasterlab.grader.course.identity
import rasterlab.grader.problem.language
import rasterlab.grader.problem.respondJson

@Serializable
private data class VersionAnswer(
    val id: String,
    val attempt: Int,
    val verdict: String?,
    val total: Int?,
    val of: Int?,
)

@Serializable
private data class LineAnswer(
    val kind: String,
    val first: Int?,
    val second: Int?,
    val before: String?,
    val after: String?,
)

@Serializable
private data class CaseStand(
    val verdict: String,
    val points: Int,
    val of: Int,
)

@Serializable
private data class CasePairAnswer(
    val name: String,
    val title: String,
    val first: CaseStand?,
    val second: CaseStand?,
)

@Serializable
private data class VersionPairAnswer(
    val first: VersionAnswer,
    val second: VersionAnswer,
    val lines: List<LineAnswer>?,
    val cases: List<CasePairAnswer>,
)

/** Serves two submissions beside each other to their owner and to staff, inside `authenticate`. */
fun Route.comparisons(pairs: VersionPairs) {
    get("/submissions/{id}/compare/{other}") {
        val (id, other) = listOf("id", "other").map { call.parameters.getOrFail(it) }
        call.respondJson(answer(pairs.of(call.identity(), id, other, call.language())))
    }
}

private fun answer(pair: VersionPair) =
    VersionPairAnswer(
        answer(pair.first),
        answer(pair.second),
        pair.lines?.map {
            LineAnswer(it.kind.code, it.first?.number, it.second?.number, it.first?.text, it.second?.text)
        },
        pair.cases.map {
            CasePairAnswer(it.either.name, it.either.title, it.first?.let(::stand), it.second?.let(::stand))
        },
    )

private fun answer(one: Version) =
    VersionAnswer(
        one.submission.id,
        one.submission.attempt,
        one.view.verdict,
        one.view.points?.total,
        one.view.points?.of,
    )

private fun stand(case: PublishedCase) = CaseStand(case.verdict.code(), case.points, case.of)
