package rasterlab.grader.web

import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import rasterlab.exercises.Grading

class PageTextsTest {
    @ParameterizedTest(name = "page names another longest source than is accepted: {0}")
    @ValueSource(strings = ["en", "ru"])
    fun `names the longest source`(language: String) {
        val text = PageTexts.of(language).problem("too-large")
        assertTrue(Regex("\\b${Grading.MOST_SOURCE_BYTES / 1024}\\b") in text, text)
    }
}
