package rasterlab.grader.web

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import rasterlab.exercises.catalogue.Catalogue

class StatementTest {
    @ParameterizedTest
    @ValueSource(strings = ["en", "ru"])
    fun `the table of points reaches students as lines of bars`(language: String) {
        for (exercise in Catalogue.builtIn().all()) {
            val html = markdownAsHtml(exercise.statement(language)) { it }
            assertTrue("<table>" in html, html)
            assertFalse("|---|" in html, html)
        }
    }

    @Test
    fun `elements written inside a table survive`() {
        val html = markdownAsHtml("| a |\n|---|\n| <b onclick='x'>c</b> |") { it }
        assertEquals(1, Regex("<td>&lt;b onclick='x'&gt;c&lt;/b&gt;</td>").findAll(html).count(), html)
    }

    @Test
    fun `a picture is looked for beside the page`() {
        val html = markdownAsHtml("![a line](segment.svg)") { "/pictures/$it" }
        assertTrue("""src="/pictures/segment.svg"""" in html && """alt="a line"""" in html, html)
    }
}
