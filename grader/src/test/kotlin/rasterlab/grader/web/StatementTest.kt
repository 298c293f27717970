package rasterlab.grader.web

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.exercises.formula.Formulas

class StatementTest {
    @ParameterizedTest
    @ValueSource(strings = ["en", "ru"])
    fun `the table of points reaches students as lines of bars`(language: String) {
        for (exercise in Catalogue.builtIn().all()) {
            val html = markdownAsHtml(exercise.statement(language), Formulas(), language) { it }
            assertTrue("<table" in html, html)
            assertFalse("|---|" in html, html)
        }
    }

    @Test
    fun `elements written inside a table survive`() {
        val html = markdownAsHtml("| a |\n|---|\n| <b onclick='x'>c</b> |", Formulas(), "en") { it }
        assertEquals(1, Regex("<td>&lt;b onclick='x'&gt;c&lt;/b&gt;</td>").findAll(html).count(), html)
    }

    @Test
    fun `a table that is too wide scrolls the page`() {
        val html = markdownAsHtml("| a |\n|---|\n| `<table>` |", Formulas(), "en") { it }
        assertEquals(1, Regex("""<div class="scroll"><table>""").findAll(html).count(), html)
        assertEquals(1, Regex("""</table></div>""").findAll(html).count(), html)
    }

    @Test
    fun `only a third column of sentences goes below the others on a phone`() {
        val head = "| for | points | how |\n|---|---|---|\n"
        assertTrue("""<table class="prose">""" in html(head + "| speed | 10 | time per point compared with ours |"))
        assertFalse("prose" in html(head + "| 1 | 2 | 7.5 |"))
        assertFalse("prose" in html("| a | b |\n|---|---|\n| 1 | time per point compared with ours |"))
    }

    @Test
    fun `a picture is looked for beside the page`() {
        val html = markdownAsHtml("![a line](segment.svg)", Formulas(), "en") { "/pictures/$it" }
        assertTrue("""src="/pictures/segment.svg"""" in html && """alt="a line"""" in html, html)
    }

    @Test
    fun `a formula is a picture with its source for those who do not see it`() {
        val html = html("Let \$a<b\$ be.")
        assertTrue("""role="img" aria-label="a&lt;b"""" in html && """fill="currentColor"""" in html, html)
        assertTrue(Regex("""viewBox="0 -\d+ \d+ \d+"""").containsMatchIn(html), html)
        assertTrue(Regex("""<path d="M[-0-9 MLQCZ]+Z"></path></svg> be""").containsMatchIn(html), html)
        assertFalse("style=" in html || "NaN" in html, html)
    }

    @Test
    fun `no line begins with the comma after a formula`() {
        assertEquals("Let <span class=\"unbroken\">F,</span> then.", line("Let \$a\$, then."))
        assertEquals("Let it be <span class=\"unbroken\">(F).</span>", line("Let it be (\$a\$)."))
        assertEquals("Let <span class=\"unbroken\">F\u00a0—</span> x", line("Let \$a\$\u00a0— x"))
        assertEquals("<span class=\"unbroken\">F–</span><span class=\"unbroken\">F,</span> x", line("\$a\$–\$b\$, x"))
        assertEquals("Let F be.", line("Let \$a\$ be."), "a line may be broken at a space")
    }

    @Test
    fun `pictures lie on white, also on a dark page`() {
        val css = checkNotNull(javaClass.getResource("assets/rasterlab.css")).readText()
        assertTrue(Regex("""\n\.statement img \{[^}]*background: #fff;""").containsMatchIn(css), "dark ink on dark")
    }

    @Test
    fun `a formula goes below the line by whole steps that the style sheet knows`() {
        val css = checkNotNull(javaClass.getResource("assets/rasterlab.css")).readText()
        for (tex in listOf("x", "x_1", "\\sqrt{\\frac{a}{b}}", "\\begin{matrix}a\\\\b\\\\c\\\\d\\\\e\\end{matrix}")) {
            val html = html("\$$tex\$")
            val steps =
                checkNotNull(
                    Regex("""class="formula down-(\d+)"""").find(html),
                    { html },
                ).groupValues[1].toInt()
            val box = checkNotNull(Regex("""viewBox="0 -(\d+) \d+ (\d+)"""").find(html)).groupValues
            assertEquals(steps * 100.0, box[2].toDouble() - box[1].toDouble(), 1.0, "$tex leaves its baseline")
            val rule = if (steps == 0) ".formula {" else ".down-$steps { vertical-align: -"
            assertTrue(rule in css, "no rule '$rule'")
        }
        assertTrue(".down-40 {" in css && ".down-41 {" !in css, "the deepest picture has another class")
    }

    @Test
    fun `lines of a formula are a paragraph of their own`() {
        val html = html("so\n$$\n\\frac{a}{b}\n- c\n$$\nis")
        assertTrue(
            Regex(
                """<p>so</p>\s*<p class="displayed"><span[^<]*<svg [^<]*<path [^<]*</path></svg><svg[^<]*</svg></span></p>\s*<p>is</p>""",
            ).containsMatchIn(html),
            html,
        )
        assertFalse("<li>" in html, html)
    }

    @Test
    fun `a displayed formula is cut though three quarters of its width would fit`() {
        val html = html("$$\n\\frac{a}{b} + c\n$$")
        val widths =
            Regex(
                """<svg [^>]*\bwidth="([0-9.]+)em"""",
            ).findAll(html).map { it.groupValues[1].toDouble() }.toList()
        assertEquals(2, widths.size, html)
        assertEquals(0.75, widths[1] / widths[0], 0.001, html)
        assertTrue("""class="least" aria-hidden="true"""" in html, html)
        assertFalse("least" in html("in a line \$x\$"), "a formula in a line has a least width")
    }

    @Test
    fun `a displayed formula scrolls without a sign of it`() {
        val css = checkNotNull(javaClass.getResource("assets/rasterlab.css")).readText()
        val rule = checkNotNull(Regex("""\n\.displayed \{([^}]*)\}""").find(css), { css }).groupValues[1]
        assertTrue("scrollbar-width: thin" in rule, rule)
        assertEquals(2, Regex("""var\(--card\)[^,;]*, transparent\)[^,;]* local""").findAll(rule).count(), rule)
        assertEquals(2, Regex("""var\(--edge\), transparent\)[^,;]* scroll""").findAll(rule).count(), rule)
        assertEquals(2, Regex("--edge: rgb").findAll(css).count(), "one shade for light and dark")
    }

    @Test
    fun `a broken formula is its source with a note in the page's language`() {
        val broken = "Let $\\foo<b$ be \$x\$.\n\n$$\na\n\nrest"
        val english = html(broken)
        assertTrue("<code>$\\foo&lt;b$</code>" in english, english)
        assertTrue("(\\foo is not a command that is known here)" in english, english)
        assertTrue("(the closing $$ is missing)" in english && "<p>rest</p>" in english, english)
        assertTrue("""aria-label="x"""" in english, english)
        assertTrue("команда \\foo здесь неизвестна" in markdownAsHtml(broken, Formulas(), "ru") { it })
    }

    /** The one paragraph, with F for each formula. */
    private fun line(markdown: String) =
        html(markdown).trim().removeSurrounding("<p>", "</p>").replace(Regex("<svg.*?</svg>"), "F")

    private fun html(markdown: String) = markdownAsHtml(markdown, Formulas(), "en") { it }
}
