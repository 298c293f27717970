package rasterlab.grader.web

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import rasterlab.exercises.Grading
import java.time.Instant
import java.time.ZoneId

class PageTextsTest {
    @ParameterizedTest(name = "page names another longest source than is accepted: {0}")
    @ValueSource(strings = ["en", "ru"])
    fun `names the longest source`(language: String) {
        val texts = PageTexts.of(language)
        val limit = Regex("\\b${Grading.MOST_SOURCE_BYTES / 1024}\\b")
        assertTrue(limit in texts.problem("too-large.source"), texts.problem("too-large.source"))
        for (other in listOf("too-large", "too-large.roster")) {
            assertFalse(limit in texts.problem(other), texts.problem(other))
        }
    }

    @Test
    @DisplayName("two moments of an hour that clocks show twice look the same, or others have an offset")
    fun `tells apart what comes twice`() {
        val texts = PageTexts.of("en", lazyOf(ZoneId.of("Europe/Berlin")))
        val told =
            mapOf(
                "2027-10-30T23:59:00Z" to "2027-10-31 01:59 Europe/Berlin",
                "2027-10-31T00:30:00Z" to "2027-10-31 02:30 +02:00 Europe/Berlin",
                "2027-10-31T01:30:00Z" to "2027-10-31 02:30 +01:00 Europe/Berlin",
                "2027-10-31T02:00:00Z" to "2027-10-31 03:00 Europe/Berlin",
            )
        for ((at, said) in told) assertEquals(said, texts.time(Instant.parse(at)))
        assertEquals("2027-10-31 02:30:07 +01:00", texts.second(Instant.parse("2027-10-31T01:30:07Z")))
    }
}
