package rasterlab.grader.web

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import rasterlab.exercises.published.PublishedCase
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.PublishedVerdict
import java.util.Optional

class AlikeCasesTest {
    @Test
    fun `twenty-five equal failures are one group at the place of the first`() {
        val equal = (1..25).map { case("equal $it", 0, "returned null") }
        val cases = listOf(case("first", 4, "")) + equal.take(1) + case("other", 0, "a hole") + equal.drop(1)
        assertEquals(listOf(listOf("first"), equal.map { it.name }, listOf("other")), names(cases))
    }

    @Test
    fun `two equal failures, cases that pass and those that say nothing stand by themselves`() {
        for (message in listOf("", "a hole")) {
            val passed = (1..9).map { case("passed $it", 4, message) }
            assertEquals(passed.map { listOf(it.name) }, names(passed))
        }
        val two = listOf(case("a", 0, "a hole"), case("b", 0, "a hole"))
        assertEquals(two.map { listOf(it.name) }, names(two))
        val silent = (1..9).map { case("silent $it", 0, "") }
        assertEquals(silent.map { listOf(it.name) }, names(silent))
    }

    private fun names(cases: List<PublishedCase>) = alike(cases).map { group -> group.map { it.name } }

    private fun case(
        name: String,
        points: Int,
        message: String,
    ) = PublishedCase(
        name,
        name,
        "hidden",
        PublishedVerdict.of(if (points > 0) GradingVerdict.OK else GradingVerdict.WRONG),
        points,
        4,
        message,
        message,
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        emptyList(),
        "",
        Optional.empty(),
    )
}
