package rasterlab.grader.web

import org.commonmark.ext.gfm.tables.TableBlock
import org.commonmark.ext.gfm.tables.TablesExtension
import org.commonmark.node.Code
import org.commonmark.node.Image
import org.commonmark.node.Node
import org.commonmark.node.Text
import org.commonmark.parser.Parser
import org.commonmark.renderer.html.AttributeProvider
import org.commonmark.renderer.html.HtmlRenderer
import rasterlab.exercises.formula.FormulaMarkdown
import rasterlab.exercises.formula.Formulas
import rasterlab.exercises.formula.InlineFormula

private val EXTENSIONS = listOf(TablesExtension.create(), FormulaMarkdown())

/**
 * Markdown, with tables and formulas, as HTML in which nothing but Markdown's own elements survives: so every table
 * there is one of Markdown's, and scrolls by itself where the page is too narrow for it.
 *
 * @param language of notes about formulas
 * @param address where a picture is, by its name
 */
fun markdownAsHtml(
    markdown: String,
    formulas: Formulas,
    language: String,
    address: (String) -> String,
): String =
    HtmlRenderer
        .builder()
        .extensions(EXTENSIONS)
        .escapeHtml(true)
        .sanitizeUrls(true)
        .attributeProviderFactory {
            AttributeProvider { node, _, attributes ->
                if (node is Image) attributes["src"] = address(node.destination)
                if (node is TableBlock && node.endsInProse()) attributes["class"] = "prose"
            }
        }.nodeRendererFactory { FormulaPictures(it, formulas, language) }
        .build()
        .render(statementTree(markdown))
        .replace("<table", "<div class=\"scroll\"><table")
        .replace("</table>", "</table></div>")

/** Whether the last of three columns holds sentences, which a narrow page shows below the other two. */
private fun TableBlock.endsInProse(): Boolean {
    val rows = children().flatMap { it.children() }
    return rows.all { it.children().count() == PROSE_COLUMNS } && rows.any { it.lastChild.letters() > FEW_LETTERS }
}

private const val PROSE_COLUMNS = 3
private const val FEW_LETTERS = 20

private fun Node.children(): Sequence<Node> = generateSequence(firstChild) { it.next }

private fun Node.letters(): Int =
    when (this) {
        is Text -> literal.length
        is Code -> literal.length
        is InlineFormula -> formula().tex().length
        else -> children().sumOf { it.letters() }
    }

internal fun statementTree(markdown: String): Node =
    Parser
        .builder()
        .extensions(EXTENSIONS)
        .postProcessor(UnbrokenFormulas)
        .build()
        .parse(markdown)
