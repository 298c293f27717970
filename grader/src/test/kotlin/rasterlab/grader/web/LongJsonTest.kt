package rasterlab.grader.web

import kotlinx.html.div
import kotlinx.html.stream.createHTML
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class LongJsonTest {
    private val long = """{"polygon":[${List(40) { "[$it,$it]" }.joinToString(",")}]}"""

    private fun html(message: String) = createHTML(prettyPrint = false).div { message(PageTexts.of("en"), message) }

    @Test
    fun longJsonIsFoldedAndWhole() {
        val html = html("smallest counterexample: $long; it has no area")
        val whole = long.replace("\"", "&quot;")
        assertEquals(1, Regex.fromLiteral(whole).findAll(html).count(), html)
        assertTrue(html.indexOf("<details>") < html.indexOf(whole), html)
        assertTrue("${whole.take(BEGINNING_AS_HTML)}…</code>; it has no area</p>" in html, html)
        assertTrue("<summary>The whole input (${long.length} characters)</summary>" in html, html)
    }

    @Test
    fun shortJsonStaysInItsSentence() {
        val html = html("""in {"from":[0,0],"to":["}",1]}: <b>""")
        val json = """{"from":[0,0],"to":["}",1]}""".replace("\"", "&quot;")
        assertEquals("<div><p>in <code>$json</code>: &lt;b&gt;</p></div>", html)
    }

    @Test
    fun whatIsNoWholeObjectIsText() {
        for (message in listOf("", "a set {1, 2}", """{"from":[0,0""", "}{")) {
            assertFalse("<code>" in html(message), message)
            assertEquals(message, partsOf(message).joinToString("") { it.text })
        }
    }

    private companion object {
        /** The forty characters that are left, with their two quotation marks as entities. */
        const val BEGINNING_AS_HTML = 50
    }
}
