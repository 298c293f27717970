package rasterlab.grader.web

import org.commonmark.ext.gfm.tables.TablesExtension
import org.commonmark.node.Image
import org.commonmark.node.Node
import org.commonmark.parser.Parser
import org.commonmark.renderer.html.AttributeProvider
import org.commonmark.renderer.html.HtmlRenderer
import rasterlab.exercises.formula.FormulaMarkdown
import rasterlab.exercises.formula.Formulas

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
            }
        }.nodeRendererFactory { FormulaPictures(it, formulas, language) }
        .build()
        .render(statementTree(markdown))
        .replace("<table>", "<div class=\"scroll\"><table>")
        .replace("</table>", "</table></div>")

internal fun statementTree(markdown: String): Node =
    Parser
        .builder()
        .extensions(EXTENSIONS)
        .build()
        .parse(markdown)
